// The specular lobe's integral over an environment by samples of it, each looked up in the mip level whose texels are as large as
// the directions that it stands for (Colbert & Krivanek 2007, GPU-Based Importance Sampling).
#include "environment/lobe_sample.glsl"
#include "environment/radiance_level.glsl"
#include "environment/sample_points.glsl"
#include "light/axes_around.glsl"

layout(constant_id = 3) const uint kEnvironmentSamples = 1;

// The light of Schlick's lobe of reflectance F0 is F0 scale + bias. n and v unit, in the environment's axes.
SpecularSums sampledSums(samplerCube radiance, vec3 n, vec3 v, float alpha, float perceptualRoughness, vec2 rotation)
{
    mat3 axes = axesAround(n);
    vec3 view = v * axes;
    float size = float(textureSize(radiance, 0).x);
    SpecularSums sums = SpecularSums(vec3(0.0), vec3(0.0));
    for (uint i = 0u; i < kEnvironmentSamples; ++i)
    {
        LobeSample s = SPECULAR_SAMPLER(view, alpha, samplePoint(i, kEnvironmentSamples, rotation));
        if (!(s.l.z > 0.0 && s.weight > 0.0))
            continue;
        float VoH = dot(view, s.h);
        float V = SELECTED_visibility(view.z, s.l.z, s.h.z, VoH, alpha, perceptualRoughness);
        vec3 l = axes * s.l;
        float level = radianceLevel(l, float(kEnvironmentSamples), s.density, size);
        addReflected(sums, textureLod(radiance, l, level).rgb * (s.weight * V), VoH);
    }
    sums.scale /= float(kEnvironmentSamples);
    sums.bias /= float(kEnvironmentSamples);
    return sums;
}
