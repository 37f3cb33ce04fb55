#include "study/filter_ladder.h"

#include "math/norm.h"
#include "plan/shading_plan.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

namespace torrance {
namespace {

using brdf::Method;
using brdf::Slot;

/// From cheap to near: one level of a texture is half the work of two, and a logarithm is more than none.
constexpr std::array<std::string_view, 4> kFilters = {"nearest_level", "trilinear_words", "trilinear",
                                                      "trilinear_exact"};

bool readsTwoLevels(const Scene& scene, const Settings& settings)
{
    return std::ranges::any_of(makePlan(scene, settings).textures,
                               [](const PlannedTexture& texture) { return texture.sampler.mip == MipFilter::linear; });
}

double relativeDifference(const Image& drawn, const Image& exact, std::span<const CoveredPixel> pixels)
{
    double difference = 0.0, norm = 0.0;
    for (const CoveredPixel& pixel : pixels) {
        difference += distance1(drawn.at(pixel.x, pixel.y), exact.at(pixel.x, pixel.y), 3);
        norm += norm1(exact.at(pixel.x, pixel.y), 3);
    }
    return norm > 0.0 ? difference / norm : 0.0;
}

} // namespace

std::optional<MethodLadder> filterLadder(const Scene& scene, const Settings& settings,
                                         std::span<const CoveredPixel> pixels,
                                         const std::function<const Image&(const Settings&)>& draw)
{
    Settings own = settings;
    const Method*& filter = own.methods.textureFilter;
    filter = brdf::findMethod(Slot::textureFilter, kFilters.back());
    if (!readsTwoLevels(scene, own))
        return std::nullopt;
    const Image exact = draw(own);
    MethodLadder ladder;
    ladder.slot = Slot::textureFilter;
    for (const std::string_view id : kFilters) {
        filter = brdf::findMethod(Slot::textureFilter, id);
        const double error = id == kFilters.back() ? 0.0 : relativeDifference(draw(own), exact, pixels);
        if (ladder.rungs.empty() || error < ladder.rungs.back().error)
            ladder.rungs.push_back({filter, 0, std::numeric_limits<double>::quiet_NaN(), error});
        else
            ladder.refused.push_back({filter, "something cheaper draws the same here"});
    }
    return ladder;
}

} // namespace torrance
