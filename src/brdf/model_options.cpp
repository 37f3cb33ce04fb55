#include "brdf/model_options.h"

#include "brdf/method.h"

#include <algorithm>

namespace torrance::brdf {
namespace {

constexpr ModelOption kModelOptions[] = {
    {"ue4_direct", "double-fresnel", "the specular term is multiplied by F once more, as ks = F",
     &ModelOptions::doubleFresnel},
    {"schlick_beckmann", "double-fresnel", "the specular term is multiplied by F once more, as Ks = F",
     &ModelOptions::doubleFresnel},
    {"ggx_burley", "no-cosine", "the light is not multiplied by n.l", &ModelOptions::noCosine},
    {"cook_torrance_beckmann", "pi-denominator", "pi in place of 4, the form of 1982", &ModelOptions::piDenominator},
    {"cook_torrance_beckmann", "energy-sketch", "diffuse * n.l + specular / n.l in place of (diffuse + specular) * n.l",
     &ModelOptions::energySketch},
    {"phong", "ambient", "what each light adds everywhere, of the base colour", &ModelOptions::ambient},
    {"phong", "specular", "factor on the highlight", &ModelOptions::specularFactor, 100.0},
    {"torrance_sparrow_blinn", "reflectivity", "0: Lambert alone; 1: the microfacet layer over it",
     &ModelOptions::reflectivity},
};

} // namespace

std::span<const ModelOption> allModelOptions()
{
    return kModelOptions;
}

const ModelOption* findModelOption(const Preset& preset, std::string_view id)
{
    const auto* found = std::ranges::find_if(
        kModelOptions, [&](const ModelOption& o) { return o.model == preset.model->id && o.id == id; });
    return found == std::end(kModelOptions) ? nullptr : found;
}

} // namespace torrance::brdf
