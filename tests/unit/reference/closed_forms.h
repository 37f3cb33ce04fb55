// Scenes that closed forms know: what several tests put together.
#pragma once

#include "brdf/method.h"
#include "scene/scene.h"

namespace torrance::test {

/// A surface that is Lambert's and nothing else, for closed forms: the base colour over pi.
inline brdf::BrdfTerms lambertAlone(const brdf::Preset&, const brdf::ShadingPoint& point)
{
    brdf::BrdfTerms terms;
    if (point.NoV <= 0 || point.NoL <= 0)
        return terms;
    terms.diffuse = terms.brdf = point.baseColor / kPi;
    terms.weight = point.NoL;
    return terms;
}

/// The preset gltf with that for its model.
inline brdf::Preset lambertPreset()
{
    static const brdf::Method model = [] {
        brdf::Method row = *brdf::findMethod(brdf::Slot::model, "gltf");
        row.formula = &lambertAlone;
        return row;
    }();
    brdf::Preset preset = *brdf::findPreset("gltf");
    preset.model = &model;
    return preset;
}

/// Of one radiance.
inline Environment uniform(const dvec3& radiance)
{
    Environment environment;
    environment.radiance = Image(8, 4, 3);
    for (std::size_t i = 0; i < environment.radiance.texels.size(); ++i)
        environment.radiance.texels[i] = static_cast<float>(radiance[static_cast<int>(i % 3)]);
    return environment;
}

} // namespace torrance::test
