#include "app/chart_session.h"

#include "app/device_option.h"
#include "app/interruption.h"
#include "app/progress_line.h"
#include "app/today.h"
#include "app/version.h"
#include "core/atomic_write.h"
#include "core/content_hash.h"
#include "core/error.h"
#include "core/log.h"
#include "core/read_file.h"
#include "gpu/shader_folder.h"
#include "study/bench_record.h"
#include "study/sphere_set.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>

namespace torrance {
namespace {

/// Ends the work at a checkpoint.
struct Interrupted
{
};

constexpr double kMostSeconds = 3600.0;

Environment requiredEnvironment(const EnvironmentOptions& options)
{
    std::optional<Environment> environment = loadChosenEnvironment(options, *brdf::findPreset("standard"));
    if (!environment)
        throw usageError("the methods of environments are told apart by one, and --environment is none",
                         "name one, or leave the option out for the studio");
    return std::move(*environment);
}

MethodChart emptyChart(const gpu::DeviceDescription& device, const Environment& environment)
{
    const BenchMachine machine = thisMachine(device);
    return {.table = {.program = versionText(),
                      .date = today(),
                      .processor = machine.processor,
                      .cores = machine.cores,
                      .system = machine.system,
                      .device = machine.device,
                      .driver = machine.driver,
                      .environment = environment.name,
                      .grid = sphereGrid(),
                      .rows = {}},
            .pictures = {}};
}

std::string inputsOf(const MeasuringOptions& options, const MethodTable& table, const Environment& environment,
                     const std::vector<brdf::Slot>& slots)
{
    ContentHasher hasher;
    for (const std::string& text : {table.program, table.processor, table.device, table.driver})
        hasher.add(text);
    for (const brdf::Slot slot : slots)
        hasher.add(brdf::slotName(slot));
    return hasher.add(options.seconds)
        .add(environment.rotation)
        .add(environment.intensity)
        .add(std::as_bytes(std::span(environment.radiance.texels)))
        .finish()
        .hex();
}

MethodChart begunChart(const std::string& part, bool resume, const std::string& inputs, MethodChart empty)
{
    if (!std::filesystem::exists(part))
        return empty;
    if (!resume) {
        logWarning(part + ": left by an interrupted run, and not used without --resume");
        return empty;
    }
    logInfo("going on with " + part);
    const std::vector<std::byte> bytes = readFile(part);
    return parsePart({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, part, inputs, std::move(empty));
}

} // namespace

void declareMeasuringOptions(CLI::App& app, MeasuringOptions& options)
{
    const char* group = "Measuring";
    app.add_option("--seconds", options.seconds, "The most time for the frames of each method (default 2)")
        ->group(group)
        ->check(CLI::Range(0.0, kMostSeconds));
    app.add_flag("--resume", options.resume, "Go on with what an interrupted run left beside its output")->group(group);
    declareEnvironmentOptions(app, options.environment);
    declareDeviceOption(app, options.device);
}

MethodChart measureMethods(const MeasuringOptions& options, const GlobalOptions& global,
                           const std::vector<brdf::Slot>& slots, const std::string& part)
{
    const Environment environment = requiredEnvironment(options.environment);
    const gpu::Device device = openDevice(options.device, global);
    gpu::ShaderLibrary shaders(gpu::shaderFolder(), cacheFolder(global));
    const TrialDevice on = {device, shaders, cacheFolder(global)};
    const MethodChart empty = emptyChart(device.description, environment);
    const std::string inputs = inputsOf(options, empty.table, environment, slots);
    MethodChart chart = begunChart(part, options.resume, inputs, empty);
    writeFile(part, partText(chart, inputs)); // what cannot be written is said before minutes are spent
    const Interruption interruption;
    ProgressLine progress("methods");
    const TrialOptions trial = {
        .environment = environment, .bounds = {.frames = 0, .seconds = options.seconds}, .checkpoint = [&] {
            if (interruption.came())
                throw Interrupted{};
        }};
    try {
        for (std::size_t i = 0; i < slots.size(); ++i) {
            if (!hasSlot(chart, slots[i])) {
                addSlot(chart, measureSlot(on, slots[i], trial));
                writeFile(part, partText(chart, inputs));
            }
            progress.show(static_cast<int>(i) + 1, static_cast<int>(slots.size()));
        }
    } catch (const Interrupted&) {
        progress.clear();
        logError("interrupted: " + part + " keeps what is finished; repeat the command with --resume");
        interruption.obey();
    }
    return chart;
}

} // namespace torrance
