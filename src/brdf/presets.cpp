#include "brdf/method.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <string>

namespace torrance::brdf {
namespace {

const Method* known(Slot slot, std::string_view id)
{
    const Method* method = findMethod(slot, id);
    assert(method && "a preset names a method that the registry lacks");
    return method;
}

Preset gltf()
{
    return {.id = "gltf",
            .description = "glTF 2.0, Appendix B to the letter",
            .model = known(Slot::model, "gltf"),
            .distribution = known(Slot::distribution, "ggx"),
            .visibility = known(Slot::visibility, "smith_corr"),
            .fresnel = known(Slot::fresnel, "schlick"),
            .diffuse = known(Slot::diffuse, "lambert"),
            .diffuseWeight = known(Slot::diffuseWeight, "fresnel_voh"),
            .multipleScattering = known(Slot::multipleScattering, "none"),
            .environmentDiffuse = known(Slot::environmentDiffuse, "irradiance_cube"),
            .environmentSpecular = known(Slot::environmentSpecular, "split_sum"),
            .dfg = known(Slot::dfg, "table"),
            .areaLight = known(Slot::areaLight, "point"),
            .textureFilter = known(Slot::textureFilter, "trilinear_words"),
            .specularAntialiasing = known(Slot::specularAntialiasing, "none"),
            .pixelSampling = known(Slot::pixelSampling, "supersampled")};
}

Preset standard()
{
    Preset preset = gltf();
    preset.id = "standard";
    preset.description = "glTF 2.0, Appendix B, with the energy that rough metals lose between microfacets put back";
    preset.multipleScattering = known(Slot::multipleScattering, "scale");
    return preset;
}

// A source system: a model that brings all its terms, lit by punctual lights alone where nothing is
// added.
Preset source(std::string_view id, std::string_view description, std::string_view model, std::string_view light)
{
    Preset preset = {};
    preset.id = id;
    preset.description = description;
    preset.model = known(Slot::model, model);
    preset.areaLight = known(Slot::areaLight, "point"); // their lights have no size
    preset.textureFilter = known(Slot::textureFilter, "trilinear_words");
    preset.specularAntialiasing = known(Slot::specularAntialiasing, "none");
    preset.pixelSampling = known(Slot::pixelSampling, "supersampled");
    preset.light = light;
    return preset;
}

// A diffuse term with 1/pi in it, and one without, look alike under these.
constexpr std::string_view kLamp = "directional:direction=-0.3,1,1,intensity=3";
constexpr std::string_view kLampWithoutPi = "directional:direction=-0.3,1,1,intensity=1";

// c / (c + 1), then the power 1/2.2; a lamp of intensity 30, here at three metres.
Preset ue4Direct()
{
    Preset preset = source("ue4-direct", "source A: textured Cook-Torrance for punctual lights, after Karis 2013",
                           "ue4_direct", "constant:direction=-0.3,1,1,distance=3,intensity=30");
    preset.tone = "reinhard";
    preset.transfer = "gamma22";
    return preset;
}

// Its environment is mirrored and refracted, and has no irradiance.
Preset phong()
{
    Preset preset =
        source("phong", "source B: ambient, diffuse and a power of the mirrored light", "phong", kLampWithoutPi);
    preset.environmentSpecular = known(Slot::environmentSpecular, "mirror");
    return preset;
}

// Lit by an environment too, from five levels, an integration map and the irradiance.
Preset ggxBurley()
{
    Preset preset =
        source("ggx-burley", "source B: GGX with Burley's diffuse, f0 = 0.5, no (1 - F)", "ggx_burley", kLamp);
    preset.environmentDiffuse = known(Slot::environmentDiffuse, "irradiance_cube");
    preset.environmentSpecular = known(Slot::environmentSpecular, "ggx_levels");
    return preset;
}

// Lit by an environment too, from an irradiance map and eight levels.
Preset torranceSparrowBlinn()
{
    Preset preset =
        source("torrance-sparrow-blinn", "source E: Blinn's D in V-grooves, between dielectric, metal and Lambert",
               "torrance_sparrow_blinn", kLamp);
    preset.environmentDiffuse = known(Slot::environmentDiffuse, "irradiance_cube");
    preset.environmentSpecular = known(Slot::environmentSpecular, "phong_levels");
    return preset;
}

// The one list of places; Preset's own type decides whether a place may be written.
template <typename P>
auto* place(P& preset, Slot slot)
{
    switch (slot) {
    case Slot::model:
        return &preset.model;
    case Slot::distribution:
        return &preset.distribution;
    case Slot::visibility:
        return &preset.visibility;
    case Slot::fresnel:
        return &preset.fresnel;
    case Slot::diffuse:
        return &preset.diffuse;
    case Slot::diffuseWeight:
        return &preset.diffuseWeight;
    case Slot::multipleScattering:
        return &preset.multipleScattering;
    case Slot::environmentDiffuse:
        return &preset.environmentDiffuse;
    case Slot::environmentSpecular:
        return &preset.environmentSpecular;
    case Slot::dfg:
        return &preset.dfg;
    case Slot::areaLight:
        return &preset.areaLight;
    case Slot::textureFilter:
        return &preset.textureFilter;
    case Slot::specularAntialiasing:
        return &preset.specularAntialiasing;
    case Slot::pixelSampling:
        return &preset.pixelSampling;
    case Slot::sheen: // of a layer that no material has yet
    case Slot::tone:  // of the output, not of the shading
    case Slot::transfer:
        break;
    }
    return decltype(&preset.distribution)(nullptr);
}

} // namespace

const Method* Preset::operator[](Slot slot) const
{
    const auto* found = place(*this, slot);
    return found ? *found : nullptr;
}

const Method*& Preset::operator[](Slot slot)
{
    auto* found = place(*this, slot);
    if (!found)
        throw std::out_of_range("a preset has no method for the slot " + std::string(slotName(slot)));
    return *found;
}

bool isComposed(const Preset& preset)
{
    return preset.model->id == "gltf";
}

std::span<const Preset> allPresets()
{
    static const Preset presets[] = {
        standard(),
        gltf(),
        ue4Direct(),
        phong(),
        source("cook-torrance-beckmann", "source B: Cook & Torrance 1982 with Beckmann's distribution",
               "cook_torrance_beckmann", kLamp),
        ggxBurley(),
        source("schlick-beckmann", "source C: GGX, Schlick's G with k = alpha/2, Lambert under 1 - F",
               "schlick_beckmann", kLamp),
        source("smith-r", "source D: GGX, Smith's G1 with r in place of alpha, diffuse n.l", "smith_r", kLampWithoutPi),
        torranceSparrowBlinn(),
    };
    return presets;
}

const Preset* findPreset(std::string_view id)
{
    const auto presets = allPresets();
    const auto found = std::ranges::find(presets, id, &Preset::id);
    return found == presets.end() ? nullptr : &*found;
}

} // namespace torrance::brdf
