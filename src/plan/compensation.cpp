#include "plan/compensation.h"

#include "brdf/albedo.h"
#include "brdf/brdf.h"

#include <algorithm>
#include <array>
#include <map>

namespace torrance {
namespace {

// Gauss-Legendre nodes and weights of order 5 on [0, 1] (Abramowitz & Stegun, table 25.4).
constexpr std::array kViews = {0.04691007703066802, 0.23076534494715845, 0.5, 0.76923465505284155, 0.95308992296933198};
constexpr std::array kViewWeights = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324,
                                     0.11846344252809454};
constexpr int kRoughnessSteps = 64;

struct AlbedoRow
{
    std::array<brdf::AlbedoTerms, kViews.size()> terms;
};

// Albedo loss grows with roughness, so rounding the roughness up keeps the bound a bound.
const AlbedoRow& albedoRow(double roughness)
{
    static thread_local std::map<int, AlbedoRow> rows;
    const int step = std::clamp(static_cast<int>(std::ceil(roughness * kRoughnessSteps)), 0, kRoughnessSteps);
    const auto [row, isNew] = rows.try_emplace(step);
    if (isNew)
        for (std::size_t i = 0; i < kViews.size(); ++i)
            row->second.terms[i] = brdf::ggxAlbedo(kViews[i], double(step) / kRoughnessSteps);
    return row->second;
}

} // namespace

double compensationGain(const MaterialRange& range)
{
    const AlbedoRow& row = albedoRow(std::clamp(range.greatestRoughness, 0.0, 1.0));
    const double metallic = std::clamp(range.greatestMetallic, 0.0, 1.0);
    double gain = 0;
    for (int c = 0; c < 3; ++c) {
        const double f0 =
            range.dielectricF0 * (1.0 - metallic) + std::clamp(range.greatestBaseColor[c], 0.0, 1.0) * metallic;
        const double diffuse =
            (1.0 - metallic) * std::clamp(range.greatestBaseColor[c], 0.0, 1.0) * (1.0 - range.dielectricF0);
        double added = 0, whole = 0;
        for (std::size_t i = 0; i < kViews.size(); ++i) {
            const brdf::AlbedoTerms& terms = row.terms[i];
            const double specular = terms.scale * f0 + terms.bias;
            added += kViewWeights[i] * kViews[i] * f0 * (1.0 / terms.albedo() - 1.0) * specular;
            whole += kViewWeights[i] * kViews[i] * (specular + diffuse);
        }
        gain = std::max(gain, added / whole);
    }
    return gain;
}

} // namespace torrance
