#include "plan/path_plan.h"

#include "core/error.h"
#include "plan/attribute_plan.h"

#include <algorithm>
#include <array>

namespace torrance {
namespace {

/// From so many triangles a pixel of the picture on, quads of triangles cost more than pixels do: each is shaded in
/// fours, of which few are seen. Measured: MetalRoughSpheresNoTextures, 1 a pixel, 0.6 of the prepass path;
/// BoomBoxWithAxes, 0.016, 0.94 to 1.1; a box of 12 triangles 1.5.
constexpr double kTrianglesPerPixel = 0.25;

// Of what the attributes path would shade once a pixel.
double attributeTriangles(const Scene& scene, const ShadingPlan& plan)
{
    double count = 0.0;
    for (const Batch& batch : plan.batches)
        if (leavesAttributes(scene, plan, batch))
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
        return {RenderPath::prepass, "what is hidden is not shaded, and too few triangles are smaller than pixels"};
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
