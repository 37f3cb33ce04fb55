// The one registry: a row per shading method. Everything that names a method (command line, GLSL file, probe, test,
// documentation) reads it from here.
#pragma once

#include "brdf/brdf_terms.h"
#include "brdf/light_query.h"
#include "brdf/model_options.h"
#include "brdf/pixel_sampling.h"
#include "brdf/shading_point.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace torrance::brdf {

/// The places of the shading equation that a method can fill.
enum class Slot
{
    model,                // how the terms are put together
    distribution,         // D, 1/sr
    visibility,           // V = G / (4 NoV NoL), 1
    fresnel,              // F per colour channel
    diffuse,              // diffuse BRDF per colour channel, 1/sr
    diffuseWeight,        // share of it that the interface above lets through, per colour channel
    multipleScattering,   // the specular lobe with what is reflected more than once, per colour channel, 1/sr
    environmentDiffuse,   // irradiance / pi from an environment
    environmentSpecular,  // prefiltered radiance from an environment
    dfg,                  // directional albedo terms of the specular lobe
    areaLight,            // reflected light of a sphere light
    sheen,                // lobe of fibres, 1/sr
    textureFilter,        // what a texture shows from afar
    specularAntialiasing, // alpha of a pixel's normals
    pixelSampling,        // a pixel's mean over its samples
    tone,                 // scene-linear to display-linear
    transfer,             // display-linear to encoded
};

/// Folder, command-line option and probe term of a slot: "distribution", "multiple_scattering", ...
std::string_view slotName(Slot slot);
/// The prefix of the function's name in GLSL and in C++: "D", "V", "F", ...
std::string_view slotPrefix(Slot slot);
/// True where a method of the slot is one function in shaders/brdf/<slot>/<id>.glsl.
bool hasShadingFunction(Slot slot);
std::span<const Slot> allSlots();
std::optional<Slot> findSlot(std::string_view name);

using ScalarFormula = double (*)(const ShadingPoint&);
using ColorFormula = dvec3 (*)(const ShadingPoint&);
/// (NoV, perceptual roughness) -> scale, bias, diffuse weight w: see albedo.h
using DfgFormula = dvec3 (*)(double NoV, double perceptualRoughness);
/// One colour to one colour: tone curves and transfer functions.
using CurveFormula = dvec3 (*)(const dvec3&);
/// Irradiance / pi, or what the specular lobe reflects, of light from all directions.
using EnvironmentFormula = dvec3 (*)(const EnvironmentQuery&);
/// Radiance towards the viewer that one sphere light causes.
using AreaFormula = dvec3 (*)(const AreaQuery&);
/// The level of detail that a texture is read from.
using LevelFormula = double (*)(const TexelFootprint&);
/// alpha with the spread of the normals under a pixel in it.
using FootprintFormula = double (*)(const NormalFootprint&);
struct Preset;
/// The whole BRDF, of the preset's other methods or of a source's own.
using ModelFormula = BrdfTerms (*)(const Preset&, const ShadingPoint&);
/// The colour of a pixel of which several samples are known.
using PixelFormula = dvec4 (*)(const PixelQuery&);
/// A slot that is judged by image, not by a formula of a point.
struct NoFormula
{
};
using Formula = std::variant<ScalarFormula, ColorFormula, DfgFormula, CurveFormula, EnvironmentFormula, AreaFormula,
                             LevelFormula, FootprintFormula, PixelFormula, ModelFormula, NoFormula>;

/// Where a method may be used: inside, it is finite, not negative, and 32 bits keep it within rounding of its formula.
/// `torrance stability` measures the same ranges; a test holds the two together.
struct Domain
{
    std::string_view text;       // what the numbers below do not say; "all" where they say everything
    double leastRoughness = 0.0; // perceptual
    double greatestRoughness = 1.0;
    double leastCosine = 0.0; // of NoV and NoL
    double leastIor = 0.0;
};

/// For people: "all", "roughness >= 0.23; NoH >= 0", ...
std::string domainText(const Domain& domain);

/// What a Fresnel term must know of the interface, beside the cosine.
enum class Interface
{
    reflectance,  // f0 and f90: a base colour says enough
    index,        // ior
    complexIndex, // eta and k
};

struct Method
{
    Slot slot;
    std::string_view id;           // names the GLSL file, the function <prefix>_<id> and the command-line value
    std::string_view citation;     // with the equation's number
    std::string_view approximates; // what it stands in for; empty: it is the exact form of what it names
    Domain domain;
    bool reciprocal;                          // claims f(v, l) = f(l, v)
    bool gainsEnergy = false;                 // somewhere in its domain it returns more light than it receives
    Interface needs = Interface::reflectance; // of the slot fresnel
    bool readsAlbedo = false;                 // of diffuse_weight and multiple_scattering: the lobe's albedo at NoV
    bool readsLightAlbedo = false;            // and at NoL, and its mean
    Formula formula;
    std::string_view ownModel = {}; // of the slot environment_specular: a source's, to which alone it belongs
    std::string_view file = {}; // GLSL below shaders/, of a slot whose functions do not stand in shaders/brdf/<slot>
};

std::span<const Method> allMethods();
const Method* findMethod(Slot slot, std::string_view id);

/// One method per slot. Null where the model brings its own term, or where its source defines no light from an
/// environment.
struct Preset
{
    std::string_view id;
    std::string_view description;
    const Method* model;
    const Method* distribution;
    const Method* visibility;
    const Method* fresnel;
    const Method* diffuse;
    const Method* diffuseWeight;
    const Method* multipleScattering;
    const Method* environmentDiffuse;
    const Method* environmentSpecular;
    const Method* dfg;
    const Method* areaLight;
    const Method* textureFilter;
    const Method* specularAntialiasing;
    const Method* pixelSampling;
    ModelOptions options = {}; // those that the model does not have are not read

    // What belongs to a source beside its formulas, unless something else is asked for.
    std::string_view tone = "khronos_neutral";
    std::string_view transfer = "srgb";
    std::string_view light = {}; // as on the command line, for scenes without any

    const Method* operator[](Slot slot) const; // null for tone and transfer
    const Method*& operator[](Slot slot);      // throws std::out_of_range for tone and transfer
};

/// True for the model `gltf`, which is composed of the preset's methods; false for a source system, which has none in
/// the slots of D, V, F, diffuse, its weight and multiple scattering.
bool isComposed(const Preset& preset);

/// `standard` (the default), `gltf`, and the source systems.
std::span<const Preset> allPresets();
const Preset* findPreset(std::string_view id);

} // namespace torrance::brdf
