// What a sphere light adds to a surface, by the method that selected.glsl chose. Included after reflected() of material/shade.glsl.
#ifdef AREA_SAMPLED
#include "light/sphere_sampled.glsl"
#else
#include "light/sphere_representative.glsl"
#endif

// `irradiance` is that of the same light in the centre, at no less than the radius.
vec3 sphereLight(Surface s, float alpha, LobeAlbedo lobe, vec3 toCenter, vec3 l, float radius, vec3 irradiance)
{
    float distance2 = dot(toCenter, toCenter);
#ifdef AREA_SAMPLED
    float height = coneHeight(coneSine2(distance2, radius));
    vec2 rotation = pixelRotation(uvec2(gl_FragCoord.xy), frame.picture);
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < kAreaSamples; ++i)
        sum += reflected(s, alpha, lobe, coneDirection(l, height, samplePoint(i, kAreaSamples, rotation)), irradiance);
    // Radiance intensity / (pi radius^2) over the cone's 2 pi height, where irradiance = intensity / max(distance, radius)^2.
    return sum * (2.0 / ((2.0 - height) * float(kAreaSamples)));
#else
    BrdfTerms center = reflectedTerms(s, alpha, lobe, l);
    BrdfTerms nearest =
        reflectedTerms(s, alpha, lobe, representativeDirection(toCenter, radius, reflect(-s.view, s.normal)));
    float energy = representativeEnergy(alpha, radius, sqrt(distance2));
    return (center.diffuse * center.weight + nearest.specular * (nearest.weight * energy)) * irradiance;
#endif
}
