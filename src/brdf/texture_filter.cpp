#include "brdf/texture_filter.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {

double T_trilinear_exact(const TexelFootprint& footprint)
{
    return std::log2(std::max(glm::length(footprint.right), glm::length(footprint.below)));
}

double T_trilinear(const TexelFootprint& footprint)
{
    return T_trilinear_exact(footprint);
}

double T_trilinear_words(const TexelFootprint& footprint)
{
    return T_trilinear_exact(footprint);
}

double T_nearest_level(const TexelFootprint& footprint)
{
    return std::ceil(T_trilinear_exact(footprint) - 0.5);
}

bool computesLevel(const Preset& methods)
{
    return methods.textureFilter->id == "trilinear_exact";
}

bool readsWords(const Preset& methods)
{
    return methods.textureFilter->id == "trilinear_words" || readsOneLevel(methods);
}

bool readsOneLevel(const Preset& methods)
{
    return methods.textureFilter->id == "nearest_level";
}

} // namespace torrance::brdf
