#include "app/command_warm.h"

#include "app/device_option.h"
#include "app/environment_option.h"
#include "app/progress_line.h"
#include "core/disk_cache.h"
#include "core/log.h"
#include "core/parallel.h"
#include "files/json_write.h"
#include "gpu/driver_environment.h"
#include "gpu/shader_folder.h"
#include "passes/renderer.h"
#include "study/warm_scenes.h"

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <mutex>
#include <set>

namespace torrance {
namespace {

namespace fs = std::filesystem;

struct Options
{
    std::string device;
    std::string only;
};

void declare(CLI::App& app, Options& o)
{
    app.add_option("--only", o.only, "The scenes whose names contain this, such as \"maps\"; --verbose names them")
        ->type_name("TEXT");
    declareDeviceOption(app, o.device);
}

constexpr std::uintmax_t kMaxStampBytes = 1u << 20;

/// Files of the driver's cache, by name, sorted. Its index changes with use, and is none of them.
std::set<std::string> driverFiles()
{
    std::set<std::string> names;
    const fs::path folder = gpu::driverCacheFolder();
    std::error_code failure;
    for (fs::recursive_directory_iterator it(folder, failure), end; !failure && it != end; it.increment(failure))
        if (it->is_regular_file(failure) && it->path().filename() != "index")
            names.insert(it->path().lexically_relative(folder).string());
    return names;
}

/// What the caches are filled for: the texts of all shaders, the driver and the processor.
ContentHash contentOf(const std::vector<WarmScene>& scenes, const Environment& environment,
                      const gpu::ShaderLibrary& shaders, const gpu::DeviceDescription& device)
{
    ContentHasher hasher;
    hasher.add(device.name).add(device.driver).add(device.driverVersion).add(gpu::driverCacheFolder().string());
    const auto addText = [&](const char* entry, const std::string& selected) {
        const ContentHash hash = shaders.gather(entry, selected).hash();
        hasher.add(hash.high).add(hash.low);
    };
    for (const WarmScene& warm : scenes) {
        hasher.add(warm.name);
        Scene scene = warm.scene;
        scene.environment = environment;
        const ShadingPlan plan = makePlan(scene, warm.settings);
        for (const auto* list : {&plan.batches, &plan.blended})
            for (const Batch& batch : *list)
                addText("passes/surface.frag", selectedText(plan, batch.key));
        for (const ShadingClass& shadingClass : plan.classes)
            addText("passes/resolve.frag", resolveText(plan, shadingClass));
    }
    for (const char* entry : {"passes/background.frag", "passes/accumulate.frag", "passes/depth.vert",
                              "passes/surface.vert", "passes/resolve.vert"})
        addText(entry, "");
    return hasher.finish();
}

std::string joined(const std::set<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
        text += name + "\n";
    return text;
}

/// Whether all that an earlier run left for this content is still there.
bool isWarm(const DiskCache& stamps, const ContentHash& content)
{
    const auto bytes = stamps.load(content);
    if (!bytes)
        return false;
    const std::set<std::string> files = driverFiles();
    const std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        if (!files.contains(text.substr(at, end - at)))
            return false;
        at = end + 1;
    }
    return true;
}

Environment builtIn(const char* name)
{
    return *loadChosenEnvironment({.name = name}, *brdf::findPreset("standard"));
}

/// One picture of a scene, to the end: what the driver compiles for it is then in its cache.
void drawOnce(Renderer& renderer, WarmScene warm, const Environment& environment)
{
    warm.scene.environment = environment;
    const ShadingPlan plan = makePlan(warm.scene, warm.settings);
    const DeviceScene onDevice = renderer.upload(warm.scene, plan);
    renderer.render(onDevice, warmCamera());
}

/// The tables of the environments that come with the program, and the sum of samples.
void warmEnvironments(Renderer& renderer, const WarmScene& any)
{
    for (const char* name : {"sky", "furnace"})
        drawOnce(renderer, any, builtIn(name));
    WarmScene sampled = any;
    sampled.settings.samples = 2;
    drawOnce(renderer, sampled, builtIn("studio"));
}

/// Devices compile side by side, each by itself: one a core, each with the next scene.
void warmPipelines(const std::vector<WarmScene>& scenes, const Environment& environment, const Options& options,
                   const GlobalOptions& global)
{
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    int done = 0;
    ProgressLine progress("warm");
    const auto work = [&] {
        const gpu::Device device({.choice = options.device});
        gpu::ShaderLibrary shaders(gpu::shaderFolder(), cacheFolder(global));
        Renderer renderer(device, shaders, cacheFolder(global));
        for (std::size_t i = next++; i < scenes.size(); i = next++) {
            if (i == 0)
                warmEnvironments(renderer, scenes[0]);
            logInfo("warm: " + scenes[i].name);
            drawOnce(renderer, scenes[i], environment);
            const std::lock_guard lock(mutex);
            progress.show(++done, static_cast<int>(scenes.size()));
        }
    };
    std::vector<std::future<void>> workers;
    for (std::size_t i = 0; i < workerCount(); ++i)
        workers.push_back(std::async(std::launch::async, work));
    for (std::future<void>& worker : workers)
        worker.get();
}

std::vector<WarmScene> chosenScenes(const std::string& only)
{
    std::vector<WarmScene> scenes = warmScenes();
    std::erase_if(scenes, [&](const WarmScene& warm) { return warm.name.find(only) == std::string::npos; });
    if (scenes.empty())
        throw usageError("no scene's name contains '" + only + "'", "leave out --only");
    return scenes;
}

[[noreturn]] void refuse(const std::string& problem)
{
    throw writeError(userCacheFolder().string(), problem, "name a folder that can be written with XDG_CACHE_HOME");
}

void checkCanWrite(const fs::path& folder)
{
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure)
        refuse("the caches cannot be written: " + failure.message());
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    if (global.noCache)
        throw usageError("warm fills the caches, and --no-cache leaves them alone", "give one of them");
    if (cacheFolder(global).empty())
        throw usageError("there is no folder for the caches", "set XDG_CACHE_HOME or HOME");
    const fs::path folder = cacheFolder(global) / "warm";
    checkCanWrite(folder);
    DiskCache stamps(folder, kMaxStampBytes);
    const std::vector<WarmScene> scenes = chosenScenes(options.only);
    const Environment environment = builtIn("studio");
    const gpu::DeviceDescription description = openDevice(options.device, global).description;
    const gpu::ShaderLibrary shaders(gpu::shaderFolder(), cacheFolder(global));
    const ContentHash content = contentOf(scenes, environment, shaders, description);
    const std::size_t before = driverFiles().size();
    const bool warm = isWarm(stamps, content);
    if (!warm) {
        warmPipelines(scenes, environment, options, global);
        const std::string files = joined(driverFiles());
        stamps.store(content, std::as_bytes(std::span(files)));
        if (!isWarm(stamps, content))
            refuse("the caches could not be filled");
    }
    const std::size_t after = driverFiles().size();
    logInfo(warm ? "the caches were warm" : "the caches are warm");
    writeJson(global.json, Json::Object{{"device", description.name},
                                        {"driver", description.driverVersion},
                                        {"scenes", scenes.size()},
                                        {"was_warm", warm},
                                        {"driver_files", after},
                                        {"driver_files_added", after - before}});
    return ExitCode::success;
}

} // namespace

Command warmCommand()
{
    return makeCommand<Options>("warm", "Fill the caches, so that models never drawn before start fast", declare, run);
}

} // namespace torrance
