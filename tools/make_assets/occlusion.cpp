#include "make_assets/occlusion.h"

#include "core/parallel.h"
#include "make_assets/light_directions.h"
#include "make_assets/noise.h"
#include "make_assets/shadow_rays.h"

#include <algorithm>
#include <cmath>

namespace torrance::assets {
namespace {

constexpr int kRays = 96; // a texel; its noise, about 1/20 at the worst, is smoothed below
constexpr int kSets =
    61; // of rays: enough that neighbours have different ones, so that noise does not become a pattern
// Rays leave this far above the surface, in metres: more than a curved mesh's sag between its vertices.
constexpr double kLift = 2e-3;

/// The part of the cosine-weighted light from these directions that is not blocked.
double openness(const ShadowRays& rays, const std::vector<dvec3>& directions, const dvec3& position,
                const dvec3& normal)
{
    double open = 0.0;
    double total = 0.0;
    for (const dvec3& direction : directions) {
        const double cosine = glm::dot(direction, normal);
        if (cosine <= 0.0)
            continue;
        total += cosine;
        if (!rays.blocked(position + kLift * normal, direction))
            open += cosine;
    }
    return total > 0.0 ? open / total : 1.0;
}

/// One pass of 1 2 1 in each direction, inside the chart.
void smooth(std::vector<double>& values, int width, int height)
{
    const std::vector<double> before = values;
    const auto value = [&](int x, int y) {
        const int cx = std::clamp(x, 0, width - 1);
        const int cy = std::clamp(y, 0, height - 1);
        return before[static_cast<std::size_t>(cy * width + cx)];
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0.0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    sum += value(x + dx, y + dy) * (2 - std::abs(dx)) * (2 - std::abs(dy)) / 16.0;
            values[static_cast<std::size_t>(y * width + x)] = sum;
        }
}

void bakeChart(Image& atlas, const DemoObject& object, const DemoPart& part, const Chart& chart, const ShadowRays& rays,
               const std::vector<std::vector<dvec3>>& lights)
{
    std::vector<double> values(static_cast<std::size_t>(chart.width * chart.height));
    parallelFor(static_cast<std::size_t>(chart.height), 1, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < chart.width; ++x) {
            const SurfacePoint point = part.surface.at(static_cast<double>(x) / (chart.width - 1),
                                                       static_cast<double>(y) / (chart.height - 1));
            const auto set = static_cast<std::size_t>(randomValue(chart.x + x, chart.y + y, 4) * kSets);
            values[static_cast<std::size_t>(y * chart.width + x)] =
                openness(rays, lights[set], placed(object, point.position), turned(object, point.normal));
        }
    });
    for (int pass = 0; pass < part.smoothing; ++pass)
        smooth(values, chart.width, chart.height);
    for (int y = 0; y < chart.height; ++y)
        for (int x = 0; x < chart.width; ++x)
            *atlas.at(chart.x + x, chart.y + y) =
                static_cast<float>(values[static_cast<std::size_t>(y * chart.width + x)]);
}

} // namespace

Image bakeOcclusion(const DemoScene& scene, const std::vector<std::vector<Chart>>& charts, const Image& panorama)
{
    const ShadowRays rays(scene);
    const std::vector<std::vector<dvec3>> lights = lightDirections(panorama, kSets, kRays);
    Image atlas(kAtlasSize, kAtlasSize, 1, 1.0f);
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        for (std::size_t j = 0; j < scene.objects[i].parts.size(); ++j)
            bakeChart(atlas, scene.objects[i], scene.objects[i].parts[j], charts[i][j], rays, lights);
    return atlas;
}

} // namespace torrance::assets
