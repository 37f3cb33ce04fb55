#include "plan/compensation.h"

#include "brdf/albedo.h"

#include <algorithm>
#include <array>
#include <map>

namespace torrance {
namespace {

constexpr double kDielectricF0 = 0.04; // glTF 2.0, Appendix B
constexpr std::array kViews = {0.05, 0.25, 0.5, 0.75, 1.0};
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
            kDielectricF0 * (1.0 - metallic) + std::clamp(range.greatestBaseColor[c], 0.0, 1.0) * metallic;
        for (const brdf::AlbedoTerms& terms : row.terms) {
            const double whole = terms.scale + terms.bias;
            const double specular = terms.scale * f0 + terms.bias;
            const double diffuse =
                (1.0 - metallic) * std::clamp(range.greatestBaseColor[c], 0.0, 1.0) * (1.0 - kDielectricF0);
            gain = std::max(gain, f0 * (1.0 / whole - 1.0) * specular / (specular + diffuse));
        }
    }
    return gain;
}

} // namespace torrance
