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
    {"ggx_burley", "five-levels",
     "five levels of an environment, level 0 among them: 5 r ends at 4, the lobe of r = 0.8",
     &ModelOptions::fiveLevels},
    {"ggx_burley", "fresnel-at-view", "an environment's F is Schlick's at n.v, beside the rise in the integration map",
     &ModelOptions::fresnelAtView},
    {"cook_torrance_beckmann", "pi-denominator", "pi in place of 4, the form of 1982", &ModelOptions::piDenominator},
    {"cook_torrance_beckmann", "energy-sketch", "diffuse * n.l + specular / n.l in place of (diffuse + specular) * n.l",
     &ModelOptions::energySketch},
    {"phong", "ambient", "what each light adds everywhere, of the base colour", &ModelOptions::ambient},
    {"phong", "specular", "factor on the highlight", &ModelOptions::specularFactor, 100.0},
    {"phong", "reflection", "share of an environment's mirror image, times (1 - n.v)^exponent",
     &ModelOptions::reflection},
    {"phong", "fresnel-exponent", "0: the share is the same at every angle", &ModelOptions::fresnelExponent, 100.0},
    {"phong", "refraction", "share of an environment's refracted image in what is not mirrored",
     &ModelOptions::refraction},
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
