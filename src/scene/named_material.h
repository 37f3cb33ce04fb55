// Materials known by name, from their reflectance at normal incidence.
#pragma once

#include "math/vector.h"

#include <span>
#include <string_view>

namespace torrance {

struct Material;

struct NamedMaterial
{
    std::string_view name;
    dvec3 f0;        // linear
    bool isMetal;    // f0 is the base colour then, and the index of refraction otherwise
    dvec3 baseColor; // of a dielectric's body: black where light goes through, which is not drawn
};

/// Metals, and dielectrics of another index than glTF's 1.5.
std::span<const NamedMaterial> namedMaterials();
const NamedMaterial* findNamedMaterial(std::string_view name);

/// Base colour, metallic, index of refraction and name of the material; the others at their defaults.
Material materialOf(const NamedMaterial& named);

} // namespace torrance
