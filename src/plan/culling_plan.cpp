#include "plan/culling_plan.h"

#include <fmt/format.h>

namespace torrance {
namespace {

/// From so many triangles a pixel of the picture on, leaving out those that show at no pixel's centre saves more than
/// it takes to find them. Time without over time with it, by `torrance bench --vary triangle-culling=on,off`, triangles
/// a pixel before the colon: BoomBoxWithAxes 0.016: 1.02, 0.064: 1.04, 0.25: 1.18; WaterBottle 0.017: 1.01,
/// 0.069: 1.02, 0.28: 1.10; SheenChair 0.038: 1.02, 0.15: 1.10; MetalRoughSpheresNoTextures 1: 1.19.
constexpr double kTrianglesPerPixel = 1.0 / 64.0;
/// Instances are drawn one by one where their triangles are chosen: of fewer triangles than this, together.
constexpr double kTrianglesPerInstance = 256.0;
/// A frame has room for so many, 12 bytes each: draws beyond it are drawn as they are.
constexpr double kMostTriangles = 1 << 24;

// Of a draw that can be culled.
template <typename Visit>
void forEachCullable(const Scene& scene, ShadingPlan& plan, Visit visit)
{
    const double least = plan.settings.triangleCulling ? 1.0 : kTrianglesPerInstance;
    double all = 0.0;
    for (Batch& batch : plan.batches)
        for (Draw& draw : batch.draws)
            if (const double triangles = triangleCount(scene, draw);
                triangles >= least * draw.instanceCount && all + triangles <= kMostTriangles)
            {
                all += triangles;
                visit(draw, triangles);
            }
}

} // namespace

void planCulling(const Scene& scene, ShadingPlan& plan)
{
    const Settings& settings = plan.settings;
    double all = 0.0;
    forEachCullable(scene, plan, [&](const Draw&, double triangles) { all += triangles; });
    const double perPixel = all / (static_cast<double>(settings.width) * settings.height);
    if (all == 0.0 || !settings.triangleCulling.value_or(perPixel >= kTrianglesPerPixel))
        return;
    forEachCullable(scene, plan, [](Draw& draw, double) { draw.culls = true; });
    plan.remarks.push_back(
        {"triangles", "those that show at no pixel's centre are left out, on a software device",
         settings.triangleCulling ? "--triangle-culling on" : fmt::format("there are {:.2g} a pixel", perPixel)});
}

} // namespace torrance
