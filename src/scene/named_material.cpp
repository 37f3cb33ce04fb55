#include "scene/named_material.h"

#include "scene/material.h"
#include "scene/phong.h"

#include <algorithm>
#include <array>

namespace torrance {
namespace {

constexpr dvec3 kNone(0.0);
constexpr dvec3 kWhite(0.8);

// Reflectances in linear light as courses teach them (Hoffman, Background: Physics and Math of Shading, SIGGRAPH 2013,
// tables of F0).
constexpr std::array<NamedMaterial, 10> kMaterials = {{
    {"water", dvec3(0.02), false, kNone},
    {"plastic", dvec3(0.04), false, kWhite},
    {"glass", dvec3(0.08), false, kNone},
    {"ruby", dvec3(0.08), false, kNone},
    {"diamond", dvec3(0.17), false, kNone},
    {"iron", dvec3(0.56, 0.57, 0.58), true, kNone},
    {"copper", dvec3(0.95, 0.64, 0.54), true, kNone},
    {"gold", dvec3(1.0, 0.71, 0.29), true, kNone},
    {"aluminium", dvec3(0.91, 0.92, 0.92), true, kNone},
    {"silver", dvec3(0.95, 0.93, 0.88), true, kNone},
}};

} // namespace

std::span<const NamedMaterial> namedMaterials()
{
    return kMaterials;
}

const NamedMaterial* findNamedMaterial(std::string_view name)
{
    const auto found =
        std::find_if(kMaterials.begin(), kMaterials.end(), [&](const NamedMaterial& m) { return m.name == name; });
    return found == kMaterials.end() ? nullptr : &*found;
}

Material materialOf(const NamedMaterial& named)
{
    Material material;
    material.name = named.name;
    material.metallicFactor = named.isMetal ? 1.0 : 0.0;
    material.baseColorFactor = dvec4(named.isMetal ? named.f0 : named.baseColor, 1.0);
    if (!named.isMetal)
        material.ior = iorOfReflectance(named.f0.r);
    return material;
}

} // namespace torrance
