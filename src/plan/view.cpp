#include "plan/view.h"

#include <algorithm>

namespace torrance {
namespace {

constexpr ViewScale kAsItIs = {};
constexpr std::optional<ViewScale> kByPeak = std::nullopt;

// The codes are those of shaders/shared/view.h, which this folder may not include; tests/image/views.cpp holds the two
// together.
constexpr View kViews[] = {
    {"albedo", 0, ViewSubject::surface, kAsItIs, "base colour, linear"},
    {"roughness", 1, ViewSubject::surface, kAsItIs, "perceptual roughness"},
    {"metallic", 2, ViewSubject::surface, kAsItIs, "metallic"},
    {"light_intensity", 3, ViewSubject::light, kByPeak, "irradiance on a surface that faces the light"},
    {"half_vector", 4, ViewSubject::light, ViewScale{0.5, 0.5}, "halfway between light and view, world axes"},
    {"n_dot_l", 5, ViewSubject::light, kAsItIs, "cosine between normal and light"},
    {"D", 6, ViewSubject::model, kByPeak, "normal distribution, 1/sr"},
    {"G1", 7, ViewSubject::model, kAsItIs, "masking of the view"},
    {"G", 8, ViewSubject::model, kAsItIs, "masking and shadowing"},
    {"V", 9, ViewSubject::model, kByPeak, "G over the denominator"},
    {"F0", 10, ViewSubject::model, kAsItIs, "reflectance at normal incidence"},
    {"F", 11, ViewSubject::model, kAsItIs, "Fresnel term at v.h"},
    {"specular", 12, ViewSubject::light, kByPeak, "specular part of the BRDF, 1/sr"},
    {"diffuse", 13, ViewSubject::light, kByPeak, "diffuse part of the BRDF, 1/sr"},
    {"brdf", 14, ViewSubject::light, kByPeak, "both parts, 1/sr"},
    {"irradiance", 15, ViewSubject::environment, kByPeak, "irradiance from the environment"},
    {"prefiltered", 16, ViewSubject::environment, kByPeak, "prefiltered radiance in the mirror direction"},
    {"dfg", 17, ViewSubject::table, kAsItIs, "scale, bias and diffuse weight of the directional albedo"},
    {"final", 18, ViewSubject::picture, kAsItIs, "what is drawn without a view"},
};

} // namespace

std::span<const View> allViews()
{
    return kViews;
}

const View* findView(std::string_view id)
{
    const auto* found = std::ranges::find(kViews, id, &View::id);
    return found == std::end(kViews) ? nullptr : found;
}

} // namespace torrance
