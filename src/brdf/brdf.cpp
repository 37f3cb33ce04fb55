#include "brdf/brdf.h"

#include "core/error.h"

namespace torrance::brdf {

void requireWholeBrdf(const Preset& preset)
{
    if (isComposed(preset) && preset.fresnel->needs != Interface::reflectance)
        throw usageError("the glTF material cannot be shaded with the Fresnel term " + std::string(preset.fresnel->id) +
                             ", which needs an index of refraction that a base colour does not give",
                         "use one of a reflectance: --fresnel schlick, sg or f82");
}

BrdfTerms evaluateTerms(const Preset& preset, const ShadingPoint& point)
{
    requireWholeBrdf(preset);
    return std::get<ModelFormula>(preset.model->formula)(preset, point);
}

dvec3 evaluateBrdf(const Preset& preset, const ShadingPoint& point)
{
    return evaluateTerms(preset, point).brdf;
}

} // namespace torrance::brdf
