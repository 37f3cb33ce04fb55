// The squared length of a step below which a texture is as good as still under the pixel: its logarithm is finite, and level -32 is read as
// any below 0 is.
const float kLeastStep2 = exp2(-64.0);

// The level of detail of Vulkan 1.3, section 16.5.7, without anisotropy: log2 of the longer of the steps in texels, from the first pixel of a
// quad to that on its right and to that below. A derivative may be that of the pixel's own row or column: the second one takes it to the
// quad's first. `texels` are the sides of level 0.
float levelOfDetail(vec2 uv, vec2 texels)
{
    vec2 place = uv * texels;
    vec2 right = dFdx(place);
    vec2 below = dFdy(place);
    vec2 inQuad = vec2(ivec2(gl_FragCoord.xy) & 1);
    right -= inQuad.y * dFdy(right);
    below -= inQuad.x * dFdx(below);
    return 0.5 * log2(max(max(dot(right, right), dot(below, below)), kLeastStep2));
}
