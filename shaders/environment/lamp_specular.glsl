// The specular lobe's integral over an environment that is split into lamps and the rest (src/prepare/environment_lamps.h): directions
// of the lobe find the rest and lamps, points find lamps once more, and what both find counts by the power heuristic (Veach &
// Guibas 1995, section 3.3, beta = 2). A narrow lobe is so left to its directions, a wide one's lamps to their points.
#include "environment/lobe_sample.glsl"
#include "environment/radiance_level.glsl"
#include "environment/sample_points.glsl"
#include "light/axes_around.glsl"
#include "light/light_block.glsl"

layout(constant_id = 3) const uint kEnvironmentSamples = 1;
layout(constant_id = 5) const uint kLampPoints = 1;

// What one way of finding light counts of it, beside another: both densities times their numbers, own > 0. Ratios, for squares of a
// mirror's densities are no floats.
float shareOf(float own, float other)
{
    float ratio = other / own;
    return 1.0 / (1.0 + ratio * ratio);
}

// n and v unit, in the environment's axes. `lamps` has their radiance and, in alpha, what of its mean is of the small kind.
// `arriving` takes what the points bring.
SpecularSums lampSums(samplerCube rest, samplerCube lamps, vec3 n, vec3 v, float alpha, float perceptualRoughness, vec2 rotation,
                      inout LampIrradiance arriving)
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
        float own = directions * s.density;
        vec2 shares = vec2(shareOf(own, points * frame.lampDensities.x), shareOf(own, points * frame.lampDensities.y));
        float share = mean > 0.0 ? mix(shares.x, shares.y, lamp.a / mean) : 0.0;
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
        float NoL = max(l.z, 0.0);
        float V = SELECTED_visibility(view.z, NoL, h.z, VoH, alpha, perceptualRoughness);
        float own = max(points * lamp.coneScale, kLeastDenominator); // black points have none
        float share = shareOf(own, directions * densityOverD * D);
        addReflected(sums, lamp.intensity * (D * V * NoL * share), VoH);
        addArriving(arriving, lamp.intensity * (NoL / PI), VoH, NoL);
    }
    return sums;
}
