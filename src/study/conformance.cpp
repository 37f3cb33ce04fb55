#include "study/conformance.h"

#include "brdf/selection.h"
#include "core/error.h"
#include "study/furnace_cases.h"
#include "study/probe_check.h"
#include "study/probe_grid.h"
#include "study/shape_cases.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

using brdf::Method;
using brdf::Preset;

/// What a device is looked at with.
struct Bench
{
    const gpu::Device& device;
    gpu::ShaderLibrary& shaders;
    Renderer& renderer;
};

/// What one case finds; an error of the device and the layer's messages meanwhile are faults of the case.
template <typename Work>
ConformanceResult resultOf(const Bench& bench, const std::string& name, const Work& work)
{
    const std::size_t seen = bench.device.validationMessages().size();
    ConformanceResult result;
    try {
        result = work();
    } catch (const Error& error) {
        result.fault = error.what();
    }
    result.name = name;
    const std::vector<std::string> messages = bench.device.validationMessages();
    for (std::size_t i = seen; i < messages.size(); ++i)
        result.fault += (result.fault.empty() ? "" : "\n") + ("validation: " + messages[i]);
    return result;
}

ConformanceResult checked(const Bench& bench, const ProbeCheck& check)
{
    const ProbeWorst worst = worstOf(bench.device, bench.shaders, check);
    const brdf::ShadingPoint& point = check.rows[worst.row];
    ConformanceResult result;
    result.excess = worst.ratio;
    result.place = fmt::format("NoV {:.3g}, NoL {:.3g}, NoH {:.6g}, roughness {:.3g}", point.NoV, point.NoL, point.NoH,
                               point.perceptualRoughness);
    result.worst = fmt::format("device ({:.9g}, {:.9g}, {:.9g}) exact ({:.9g}, {:.9g}, {:.9g}) error {:.3g} at {}",
                               worst.device.x, worst.device.y, worst.device.z, worst.exact.x, worst.exact.y,
                               worst.exact.z, worst.error, describe(point));
    return result;
}

using Results = std::vector<ConformanceResult>;

Results probeMethods(const Bench& bench)
{
    Results results;
    for (const Method* method : probedMethods())
        results.push_back(resultOf(bench, brdf::functionName(*method), [&] {
            ConformanceResult result = checked(bench, methodCheck(*method));
            result.fault = cornerFault(bench.device, bench.shaders, *method);
            return result;
        }));
    return results;
}

Results probePresets(const Bench& bench)
{
    Results results;
    for (const Preset& preset : brdf::allPresets())
        results.push_back(resultOf(bench, std::string(preset.id), [&] { return checked(bench, brdfCheck(preset)); }));
    results.push_back(resultOf(bench, "directional albedo", [&] { return checked(bench, albedoCheck()); }));
    for (const Method* fit : dfgFits())
        results.push_back(resultOf(bench, "directional albedo, " + std::string(fit->id),
                                   [&] { return checked(bench, dfgFitCheck(*fit)); }));
    return results;
}

ConformanceResult drawn(const Bench& bench, const PictureCase& c)
{
    const ShadingPlan plan = makePlan(c.scene, c.settings);
    const DeviceScene scene = bench.renderer.upload(c.scene, plan);
    ConformanceResult result;
    result.drawn = bench.renderer.render(scene, c.camera).color;
    PictureJudgement judgement = c.judge(c, result.drawn);
    result.excess = judgement.worst.excess;
    result.place = fmt::format("pixel ({}, {})", judgement.worst.x, judgement.worst.y);
    result.worst = judgement.worst.text();
    result.fault = std::move(judgement.fault);
    result.exact = std::move(judgement.exact);
    result.difference = std::move(judgement.excess);
    return result;
}

void draw(const Bench& bench, Results& results, const std::vector<PictureCase>& cases)
{
    for (const PictureCase& c : cases)
        results.push_back(resultOf(bench, c.name, [&] { return drawn(bench, c); }));
}

Results drawFurnace(const Bench& bench)
{
    Results results;
    for (const double metallic : {0.0, 0.5, 1.0})
        draw(bench, results, furnaceCases("gltf", metallic));
    draw(bench, results, furnaceCases("standard", 1.0));
    return results;
}

Results drawShapes(const Bench& bench)
{
    Results results;
    for (const auto shape : {AnalyticShape::Kind::sphere, AnalyticShape::Kind::plane}) {
        for (const auto light : {Light::Kind::directional, Light::Kind::point, Light::Kind::spot})
            draw(bench, results, shapeCases(shape, light));
        draw(bench, results, shapeCasesInUniformLight(shape));
    }
    return results;
}

Results drawPresets(const Bench& bench)
{
    Results results;
    for (const Preset& preset : brdf::allPresets())
        draw(bench, results, presetSpheres(preset));
    std::vector<PictureCase> sourceC = presetSpheres(*brdf::findPreset("schlick-beckmann")); // shades from a G-buffer
    for (PictureCase& c : sourceC) {
        c.name += ", deferred";
        c.settings.path = RenderPath::deferred;
    }
    draw(bench, results, sourceC);
    return results;
}

struct GroupRow
{
    const char* name;
    const char* expectation;
    Results (*run)(const Bench&);
};

constexpr GroupRow kGroups[] = {
    {"methods",
     "Every shading function of the registry, as the device computes it from the same scalars as the double formula, "
     "is "
     "within 5e-6 of it over the grid (the textbook's GGX within what its cancellation leaves), and finite, not "
     "negative and within its bounds where scalars are at the ends of their ranges.",
     probeMethods},
    {"brdf",
     "The whole BRDF of every preset, from vectors, is within 2e-6 and twice what rounding its inputs to float can "
     "change (eight times below roughness 0.02); the table of directional albedos is within 1e-4 of the "
     "integral, and each fit of it within 1e-4 and 4e-6 of its double formula.",
     probePresets},
    {"furnace",
     "A white sphere in white light returns what the integral of the model says, and white metal with compensation "
     "returns all of it: within 0.002 wherever n.v is at least 0.05.",
     drawFurnace},
    {"shapes",
     "Every pixel of a sphere and of a plane under each kind of light is within 1e-4 of the double formulas, a "
     "millionth of the brightest pixel, and twice what rounding the pixel's inputs to float can change.",
     drawShapes},
    {"presets",
     "Every pixel of spheres in each preset under a point light, as near as in the group shapes; schlick-beckmann on "
     "the deferred path as well.",
     drawPresets},
};

} // namespace

bool ConformanceGroup::passed() const
{
    return std::ranges::all_of(results, &ConformanceResult::passed);
}

std::vector<std::string> conformanceGroupNames()
{
    std::vector<std::string> names;
    for (const GroupRow& group : kGroups)
        names.emplace_back(group.name);
    return names;
}

std::vector<ConformanceGroup> runConformance(const gpu::Device& device, gpu::ShaderLibrary& shaders, Renderer& renderer,
                                             std::span<const std::string> names,
                                             const std::function<void(const ConformanceGroup&)>& done)
{
    const Bench bench{device, shaders, renderer};
    std::vector<ConformanceGroup> groups;
    for (const GroupRow& group : kGroups) {
        if (std::ranges::find(names, group.name) == names.end())
            continue;
        groups.push_back({group.name, group.expectation, group.run(bench)});
        done(groups.back());
    }
    return groups;
}

} // namespace torrance
