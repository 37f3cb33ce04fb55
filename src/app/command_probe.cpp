#include "app/command_probe.h"

#include "app/device_option.h"
#include "app/method_options.h"
#include "app/option_value.h"
#include "app/probe_rows.h"
#include "brdf/condition.h"
#include "brdf/lobe_albedo.h"
#include "core/atomic_write.h"
#include "core/log.h"
#include "core/nearest_name.h"
#include "core/parallel.h"
#include "core/read_file.h"
#include "core/standard_output.h"
#include "files/csv_read.h"
#include "files/json_write.h"
#include "gpu/shader_folder.h"
#include "passes/probe_pass.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace torrance {
namespace {

using brdf::Method;
using brdf::Preset;
using brdf::ShadingPoint;
using brdf::Slot;

struct Options
{
    std::string term, method, preset = "standard", input, output = "-", device;
    ModelChoices model;
};

std::vector<std::string> termNames()
{
    std::vector<std::string> names = {"brdf", "albedo"};
    for (const Slot slot : brdf::allSlots())
        names.emplace_back(brdf::slotName(slot));
    return names;
}

void declare(CLI::App& app, Options& options)
{
    std::vector<std::string> presets;
    for (const Preset& preset : brdf::allPresets())
        presets.emplace_back(preset.id);
    addChoice(app, "--term", options.term, termNames(), "What to evaluate")->required();
    app.add_option("--method", options.method, "The slot's method; without it, the preset's")->type_name("ID");
    addChoice(app, "--preset", options.preset, presets, "Methods of the term brdf");
    declareModelChoices(app, options.model);
    app.add_option("--input", options.input,
                   "Table of rows: id, nx..nz, vx..vz, lx..lz, roughness, and what the term reads of metallic, "
                   "base_r..base_b, ior, eta, k, f82_r..f82_b, tx..tz, anisotropy")
        ->type_name("CSV")
        ->required();
    app.add_option("-o,--output", options.output, "Table of results ('-': standard output)")->type_name("CSV");
    declareDeviceOption(app, options.device);
}

const Method& methodOf(Slot slot, const Options& options)
{
    const std::string& id = options.method;
    if (id.empty()) {
        if (const Method* method = (*brdf::findPreset(options.preset))[slot])
            return *method;
        throw usageError("the term " + options.term + " needs --method", "torrance methods lists them");
    }
    if (const Method* method = brdf::findMethod(slot, id))
        return *method;
    std::vector<std::string> ids;
    for (const Method& method : brdf::allMethods())
        if (method.slot == slot)
            ids.emplace_back(method.id);
    const std::string nearest = nearestName(id, ids);
    throw usageError("unknown method " + id + " of the term " + options.term,
                     nearest.empty() ? "torrance methods lists them" : "did you mean " + nearest + "?");
}

struct Term
{
    ProbeTerm probe;
    ProbeColumns columns;
    std::string method; // id, or that of the preset
};

Term chooseTerm(const Options& options)
{
    const std::optional<Slot> slot = brdf::findSlot(options.term);
    if (options.term != "brdf" && !(options.model.quirks + options.model.parameters).empty())
        throw usageError("--quirk and --parameter are for the term brdf, not for " + options.term, "leave them out");
    if (!slot) {
        if (!options.method.empty())
            throw usageError("--method is for the terms that are slots, not for " + options.term,
                             options.term == "brdf" ? "use --preset" : "leave it out");
        if (options.term == "albedo")
            return {makeAlbedoTerm(), {}, "table"};
        Preset preset = *brdf::findPreset(options.preset);
        applyModelChoices(options.model, preset);
        return {makeBrdfTerm(preset), {.baseColor = true, .metallic = true}, options.preset};
    }
    const Method& method = methodOf(*slot, options);
    return {makeProbeTerm(method),
            {.baseColor = *slot == Slot::diffuse || *slot == Slot::model,
             .metallic = *slot == Slot::model,
             .ior = method.needs == brdf::Interface::index,
             .conductor = method.needs == brdf::Interface::complexIndex,
             .f82 = method.id == "f82",
             .tangent = method.id == "ggx_aniso"},
            std::string(method.id)};
}

void readOtherTerms(const ProbeTerm& term, ShadingPoint& point)
{
    if (term.readsInterface)
        brdf::setInterface(point);
    else if (term.readsAlbedo)
        brdf::setLobeAlbedo(point);
}

// With the other terms of the very point, wherever differences move it.
dvec3 exactValue(const ProbeTerm& term, ShadingPoint point)
{
    readOtherTerms(term, point);
    return term.formula(point);
}

// The greatest of the channels, each relative to the exact value, or to the least normal float where that is smaller: a
// device may flush what lies below to zero.
double relativeError(const vec3& device, const dvec3& exact)
{
    double worst = 0;
    for (int channel = 0; channel < 3; ++channel) {
        const double difference = std::abs(static_cast<double>(device[channel]) - exact[channel]);
        const double error = difference / std::max(std::abs(exact[channel]), static_cast<double>(FLT_MIN));
        if (!(error <= worst)) // a NaN is the worst
            worst = error;
    }
    return worst;
}

struct Result
{
    vec3 device = vec3(0);
    dvec3 exact = dvec3(0);
    double rel = 0;
    double kappa = 0;
};

std::vector<Result> evaluate(const gpu::Device& device, gpu::ShaderLibrary& shaders, const ProbeTerm& term,
                             std::vector<ShadingPoint> points)
{
    std::vector<Result> results(points.size());
    const auto formula = [&](const ShadingPoint& point) { return exactValue(term, point); };
    constexpr std::size_t kGrain = 16;
    parallelFor(points.size(), kGrain, [&](std::size_t i) {
        readOtherTerms(term, points[i]);
        results[i].exact = formula(points[i]);
        results[i].kappa = brdf::conditionNumber(formula, points[i]);
    });
    const std::vector<vec3> values = probe(device, shaders, term, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        results[i].device = values[i];
        results[i].rel = relativeError(values[i], results[i].exact);
    }
    return results;
}

std::string toCsv(const std::vector<std::string>& ids, const std::vector<Result>& results)
{
    std::string text = "id,device_r,device_g,device_b,cpu_r,cpu_g,cpu_b,rel,kappa\n";
    for (std::size_t i = 0; i < results.size(); ++i) {
        const Result& r = results[i];
        text += fmt::format("{},{},{},{},{},{},{},{:.6g},{:.6g}\n", csvCell(ids[i]), r.device.x, r.device.y, r.device.z,
                            r.exact.x, r.exact.y, r.exact.z, r.rel, r.kappa);
    }
    return text;
}

Json summary(const Options& options, const Term& term, const gpu::Device& device, const std::vector<std::string>& ids,
             const std::vector<Result>& results)
{
    Json::Object object = {
        {"term", options.term}, {"method", term.method}, {"device", device.description.name}, {"rows", results.size()}};
    const auto worst = std::ranges::max_element(results, {}, &Result::rel);
    if (worst != results.end())
        object.emplace_back("worst", Json::Object{{"id", ids[static_cast<std::size_t>(worst - results.begin())]},
                                                  {"rel", worst->rel},
                                                  {"kappa", worst->kappa}});
    return object;
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    if (options.output == "-" && global.json == "-")
        throw usageError("both results go to standard output", "give a file to -o or to --json");
    const Term term = chooseTerm(options);
    const std::vector<std::byte> bytes = readFile(options.input);
    const std::string_view csv(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const ProbeRows rows = parseProbeRows(csv, options.input, term.columns);

    if (!rows.nonUnit.empty())
        logWarning(options.input + ": " + rows.nonUnit + ": is not of length 1; all directions are made unit");

    const gpu::Device device = openDevice(options.device, global);
    gpu::ShaderLibrary shaders(gpu::shaderFolder(), cacheFolder(global));
    const std::vector<Result> results = evaluate(device, shaders, term.probe, rows.points);

    const std::string text = toCsv(rows.ids, results);
    if (options.output == "-")
        writeStandardOutput(text);
    else
        writeFile(options.output, text);
    writeJson(global.json, summary(options, term, device, rows.ids, results));
    return ExitCode::success;
}

} // namespace

Command probeCommand()
{
    return makeCommand<Options>("probe", "Evaluate a shading term on the device and in double, row by row", declare,
                                run);
}

} // namespace torrance
