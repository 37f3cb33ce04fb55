#include "plan/path_plan.h"

#include "core/error.h"
#include "plan/attribute_plan.h"

#include <algorithm>
#include <array>

namespace torrance {
namespace {

/// From so many triangles a pixel of the picture on, shading at their edges costs more than keeping attributes does: a
/// triangle is shaded in whole vectors of pixels. Time of the attributes path over that of the prepass, by
/// `torrance bench --vary path=prepass,attributes` at several sizes of the picture, triangles a pixel before the colon:
/// WaterBottle 0.069: 0.78, 0.017: 1.05; BoomBoxWithAxes 0.064: 0.93, 0.028: 1.00, 0.016: 1.10.
constexpr double kTrianglesPerPixel = 1.0 / 32.0;

// Of what the attributes path would shade once a pixel.
double attributeTriangles(const Scene& scene, const ShadingPlan& plan)
{
    double count = 0.0;
    for (const Batch& batch : plan.batches)
        if (leavesAttributes(plan, batch))
            for (const Draw& draw : batch.draws)
                count += triangleCount(scene, draw);
    return count;
}

/// Analytic shapes have no depth pass, and what is unlit costs no more than one.
bool anyLitMesh(const ShadingPlan& plan)
{
    return std::ranges::any_of(plan.batches, [](const Batch& batch) {
        return batch.draws.front().primitive >= 0 && !batch.key.unlit && batch.key.normals;
    });
}

/// What is asked for and cannot be drawn from attributes; null: nothing.
const char* lackOfAttributes(const ShadingPlan& plan)
{
    if (plan.settings.view)
        return "views of a term";
    const brdf::Method* method = plan.settings.methods.specularAntialiasing;
    return method && method->id != "none" ? "specular antialiasing, which reads how the normal turns along the surface"
                                          : nullptr;
}

struct Reason
{
    RenderPath path;
    std::string text;
};

Reason chosen(const Scene& scene, const ShadingPlan& plan)
{
    const Settings& s = plan.settings;
    const double perPixel = attributeTriangles(scene, plan) / (static_cast<double>(s.width) * s.height);
    if (!anyLitMesh(plan))
        return {RenderPath::forward, "no opaque mesh is lit"};
    if (perPixel < kTrianglesPerPixel)
        return {RenderPath::prepass, "what is hidden is not shaded, and triangles cover many pixels"};
    if (const char* lack = lackOfAttributes(plan))
        return {RenderPath::prepass, std::string("the attributes path lacks ") + lack};
    return {RenderPath::attributes, "there are " + std::to_string(perPixel) + " triangles a pixel"};
}

} // namespace

void choosePath(const Scene& scene, ShadingPlan& plan)
{
    if (plan.settings.path) {
        plan.path = *plan.settings.path;
        if (const char* lack = lackOfAttributes(plan); lack && plan.path == RenderPath::attributes)
            throw usageError(std::string("the attributes path lacks ") + lack, "use --path prepass");
        return;
    }
    const Reason reason = chosen(scene, plan);
    plan.path = reason.path;
    plan.remarks.push_back({"surfaces", std::string("path ") + nameOf(reason.path), reason.text});
}

const char* nameOf(RenderPath path)
{
    constexpr std::array kNames = {"forward", "prepass", "attributes", "deferred"};
    return kNames[static_cast<std::size_t>(path)];
}

} // namespace torrance
