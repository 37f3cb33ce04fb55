// A material without what it does not need: constant channels become factors, black or flat maps go.
#pragma once

#include "plan/remark.h"
#include "plan/texel_facts.h"
#include "scene/scene.h"

#include <span>

namespace torrance {

/// What the surfaces of a material can be, texels included: bounds, not averages.
struct MaterialRange
{
    double leastRoughness = 0, greatestRoughness = 1; // perceptual
    double greatestMetallic = 1;
    double dielectricF0 = 0.04;           // reflectance at normal incidence
    dvec3 greatestBaseColor = dvec3(1.0); // linear
};

struct PlannedMaterial
{
    Material material; // draws the same picture as the scene's
    MaterialRange range;
    bool compensates = false;                             // multiple scattering is computed
    bool roughnessVaries = false, metallicVaries = false; // over metallicRoughness; else they are in the factors
};

/// `facts` is per Scene::images. A name is given to nameless materials ("material 3").
PlannedMaterial planMaterial(const Scene& scene, const Material& material, std::span<const TexelFacts> facts,
                             const std::string& subject, Remarks& remarks);

} // namespace torrance
