// The specular lobe's integral over an environment that is split into lamps and the rest (src/prepare/environment_lamps.h): directions
// of the lobe find the rest and lamps, points find lamps once more, and what both find counts by the balance heuristic (Veach &
// Guibas 1995, section 3.2). A narrow lobe is so left to its directions, a wide one's lamps to their points.
#include "environment/lobe_sample.glsl"
#include "environment/radiance_level.glsl"
#include "environment/sample_points.glsl"
#include "light/axes_around.glsl"
#include "light/light_block.glsl"

layout(constant_id = 3) const uint kEnvironmentSamples = 1;
layout(constant_id = 5) const uint kLampPoints = 1;

// n and v unit, in the environment's axes. `lamps` has their radiance and, in alpha, its mean times the density of their points.
SpecularSums lampSums(samplerCube rest, samplerCube lamps, vec3 n, vec3 v, float alpha, float perceptualRoughness, vec2 rotation)
{
    const float directions = float(kEnvironmentSamples), points = float(kLampPoints);
    mat3 axes = axesAround(n);
    vec3 view = v * axes;
    float size = float(textureSize(rest, 0).x);
    SpecularSums sums = SpecularSums(vec3(0.0), vec3(0.0));
    for (uint i = 0u; i < kEnvironmentSamples; ++i)
    {
        LobeSample s = Es_vndf_bounded(view, alpha, samplePoint(i, kEnvironmentSamples, rotation));
        if (!(s.l.z > 0.0 && s.weight > 0.0))
            continue;
        float VoH = dot(view, s.h);
        float V = SELECTED_visibility(view.z, s.l.z, s.h.z, VoH, alpha, perceptualRoughness);
        vec3 l = axes * s.l;
        float level = radianceLevel(l, directions, s.density, size);
        vec4 lamp = textureLod(lamps, l, level);
        float mean = (lamp.r + lamp.g + lamp.b) * (1.0 / 3.0);
        float own = directions * s.density * mean; // both densities times the light: black lamps have none
        float share = mean > 0.0 ? own / (own + points * lamp.a) : 0.0;
        vec3 light = textureLod(rest, l, level).rgb + lamp.rgb * share;
        addReflected(sums, light * (s.weight * V / directions), VoH);
    }
    float densityOverD = boundedDensityOverD(view, alpha);
    for (uint i = 0u; i < kLampPoints; ++i)
    {
        Light lamp = lights[kDirectionalCount + kPointCount + kSpotCount + i];
        vec3 l = lamp.direction * axes;
        vec3 both = view + l;
        float length2 = max(dot(both, both), kLeastDenominator); // of opposite directions: l is below the horizon
        vec3 h = both * inversesqrt(length2);
        float VoH = 0.5 * sqrt(length2);
        float D = ggxOf(h, alpha);
        float V = SELECTED_visibility(view.z, max(l.z, 0.0), h.z, VoH, alpha, perceptualRoughness);
        float own = points * lamp.coneScale;
        float share = own / (own + directions * densityOverD * D + kLeastDenominator);
        addReflected(sums, lamp.intensity * (D * V * max(l.z, 0.0) * share), VoH);
    }
    return sums;
}
