// What the slots of the registry are called.
#include "brdf/method.h"

#include <algorithm>

namespace torrance::brdf {
namespace {

struct SlotNames
{
    Slot slot;
    std::string_view name;
    std::string_view prefix;
    bool shadingFunction;
};

constexpr SlotNames kSlotNames[] = {
    {Slot::model, "model", "model", true},
    {Slot::distribution, "distribution", "D", true},
    {Slot::visibility, "visibility", "V", true},
    {Slot::fresnel, "fresnel", "F", true},
    {Slot::diffuse, "diffuse", "Fd", true},
    {Slot::diffuseWeight, "diffuse_weight", "W", true},
    {Slot::multipleScattering, "multiple_scattering", "M", true},
    {Slot::environmentDiffuse, "environment_diffuse", "Ed", false},
    {Slot::environmentSpecular, "environment_specular", "Es", false},
    {Slot::dfg, "dfg", "DFG", false},
    {Slot::areaLight, "area_light", "A", false},
    {Slot::sheen, "sheen", "S", true},
    {Slot::textureFilter, "texture_filter", "T", false},
    {Slot::specularAntialiasing, "specular_antialiasing", "AA", false},
    {Slot::pixelSampling, "pixel_sampling", "PS", false},
    {Slot::tone, "tone", "tone", false},
    {Slot::transfer, "transfer", "transfer", false},
};

constexpr Slot kSlots[] = {
    Slot::model,
    Slot::distribution,
    Slot::visibility,
    Slot::fresnel,
    Slot::diffuse,
    Slot::diffuseWeight,
    Slot::multipleScattering,
    Slot::environmentDiffuse,
    Slot::environmentSpecular,
    Slot::dfg,
    Slot::areaLight,
    Slot::sheen,
    Slot::textureFilter,
    Slot::specularAntialiasing,
    Slot::pixelSampling,
    Slot::tone,
    Slot::transfer,
};

} // namespace

std::string_view slotName(Slot slot)
{
    return kSlotNames[static_cast<int>(slot)].name;
}

std::string_view slotPrefix(Slot slot)
{
    return kSlotNames[static_cast<int>(slot)].prefix;
}

bool hasShadingFunction(Slot slot)
{
    return kSlotNames[static_cast<int>(slot)].shadingFunction;
}

std::span<const Slot> allSlots()
{
    return kSlots;
}

std::optional<Slot> findSlot(std::string_view name)
{
    const auto* found = std::ranges::find(kSlotNames, name, &SlotNames::name);
    return found == std::end(kSlotNames) ? std::nullopt : std::optional(found->slot);
}

} // namespace torrance::brdf
