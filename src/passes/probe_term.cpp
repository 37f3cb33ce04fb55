#include "passes/probe_term.h"

#include "brdf/brdf.h"
#include "brdf/dfg.h"
#include "brdf/selection.h"
#include "core/error.h"

#include <algorithm>

namespace torrance {
namespace {

using brdf::Slot;

// The arguments of a slot's functions, the same for all its methods.
std::string argumentsOf(Slot slot)
{
    switch (slot) {
    case Slot::distribution:
        return "row.NoH, row.sin2H, row.alpha, row.ToH, row.BoH, row.alphaT, row.alphaB";
    case Slot::visibility:
        return "row.NoV, row.NoL, row.NoH, row.VoH, row.alpha, row.perceptualRoughness";
    case Slot::fresnel:
        return "row.VoH, row.oneLessVoH, row.f0, row.f90, row.ior, row.eta, row.k, row.f82";
    case Slot::diffuse:
        return "row.NoV, row.NoL, row.VoL, row.NoH, row.VoH, row.alpha, row.perceptualRoughness, row.baseColor";
    case Slot::sheen:
        return "row.NoV, row.NoL, row.NoH, row.sin2H, row.alpha";
    case Slot::multipleScattering:
        return "row.single, row.spread, row.f0, row.bias, row.E, row.ELight, row.EAverage";
    case Slot::diffuseWeight:
        return "row.F, row.FNoV, row.FNoL, row.lobeAlbedo";
    default:
        return {};
    }
}

double seenCosine(const brdf::ShadingPoint& point)
{
    return std::clamp(point.NoV, 0.0, 1.0); // as shaders/material/shade.glsl has it
}

// A look-up as the renderer makes it; `members` of (scale, bias, w, E).
std::string lookUp(const std::string& members)
{
    return "#define DFG_TABLE\n"
           "#include \"environment/lighting.glsl\"\n"
           "#define PROBE_VALUE vec3(directionalAlbedo(clamp(row.NoV, 0.0, 1.0), row.perceptualRoughness)." +
           members + ")\n";
}

ProbeTerm makeDfgTerm(const brdf::Method& method, brdf::DfgFormula formula)
{
    ProbeTerm term = {
        .formula = [formula](const brdf::ShadingPoint& p) { return formula(seenCosine(p), p.perceptualRoughness); },
        .selected = lookUp("xyz")};
    if (brdf::findDfgTable(method.id)) {
        term.readsTable = true;
        term.table = method.id;
    } else {
        term.selected.insert(0, "#include \"" + brdf::glslPath(method) + "\"\n#define DFG_FIT " +
                                    brdf::functionName(method) + "\n");
    }
    return term;
}

// A model is probed as the whole of the preset that it belongs to; the plainest of them for the model gltf.
const brdf::Preset& presetOf(const brdf::Method& model)
{
    if (model.id == "gltf")
        return *brdf::findPreset("gltf");
    return *std::ranges::find(brdf::allPresets(), &model, &brdf::Preset::model);
}

dvec3 valueOf(const brdf::Method& method, const brdf::ShadingPoint& point)
{
    if (const auto* scalar = std::get_if<brdf::ScalarFormula>(&method.formula))
        return dvec3((*scalar)(point));
    return std::get<brdf::ColorFormula>(method.formula)(point);
}

} // namespace

ProbeTerm makeProbeTerm(const brdf::Method& method)
{
    if (method.slot == Slot::model)
        return makeBrdfTerm(presetOf(method));
    if (const auto* table = std::get_if<brdf::DfgFormula>(&method.formula))
        return makeDfgTerm(method, *table);
    if (!brdf::hasShadingFunction(method.slot))
        throw usageError("the slot " + std::string(brdf::slotName(method.slot)) + " has no function of a shading point",
                         "compare pictures instead: torrance render, torrance compare");
    return {.formula = [&method](const brdf::ShadingPoint& point) { return valueOf(method, point); },
            .selected = "#include \"" + brdf::glslPath(method) + "\"\n#define PROBE_VALUE vec3(" +
                        brdf::functionName(method) + "(" + argumentsOf(method.slot) + "))\n",
            .readsInterface = method.slot == Slot::multipleScattering || method.slot == Slot::diffuseWeight};
}

ProbeTerm makeBrdfTerm(const brdf::Preset& preset)
{
    return {.formula = [preset](const brdf::ShadingPoint& point) { return brdf::evaluateBrdf(preset, point); },
            .selected =
                brdf::selectedGlsl(preset) +
                "#define PROBE_VALUE SELECTED_model(BrdfInput(row.n, row.v, row.l, row.baseColor, row.metallic, "
                "row.perceptualRoughness, row.alpha, row.ior, LobeAlbedo(row.E, row.bias, row.ELight, "
                "row.EAverage))).brdf\n",
            .readsAlbedo = brdf::isComposed(preset) &&
                           (preset.multipleScattering->readsAlbedo || preset.diffuseWeight->readsAlbedo)};
}

ProbeTerm makeAlbedoTerm()
{
    return {
        .formula =
            [](const brdf::ShadingPoint& p) { return dvec3(brdf::lobeAlbedo(seenCosine(p), p.perceptualRoughness)); },
        .selected = lookUp("w"),
        .readsTable = true};
}

} // namespace torrance
