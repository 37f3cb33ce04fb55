// One picture to be timed: from its scene to its bytes once, then frame by frame.
#pragma once

#include "core/process_usage.h"
#include "passes/renderer.h"
#include "plan/shading_plan.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace torrance {

/// What a picture is made from.
struct BenchSource
{
    std::string name;
    std::function<Scene()> load;
    std::function<Camera(const Scene&)> camera;
    Settings settings;
};

struct PhaseTime
{
    std::string name;
    TimeUse use;
};

/// A pass submitted by itself, with a fence that is waited for.
struct PassTimes
{
    std::string name;
    std::vector<double> processor; // seconds, frame by frame
    std::vector<double> wall;
};

/// A scene on the device with a renderer of its own, so that nothing of another is there to be reused.
class BenchItem
{
public:
    /// Draws the picture twice and encodes it; what each step took is startUp(). Throws what its parts throw.
    BenchItem(const gpu::Device& device, gpu::ShaderLibrary& shaders, const std::filesystem::path& cacheFolder,
              const BenchSource& source);
    BenchItem(const BenchItem&) = delete; // what is on the device refers to scene and plan
    BenchItem& operator=(const BenchItem&) = delete;

    /// load, plan, upload, first draw (with the driver's compilation), second draw, read back, display transform,
    /// encode (PNG), in this order.
    const std::vector<PhaseTime>& startUp() const { return phases; }
    /// Bytes of its own that the process holds since, freed ones given back.
    std::uint64_t heldBytes() const { return held; }
    const Scene& drawnScene() const { return scene; }
    const ShadingPlan& shadingPlan() const { return plan; }
    std::size_t pipelineCount() const { return renderer.pipelineCount(); }

    /// All samples of a picture, left on the device.
    TimeUse drawFrame();
    /// One sample, each pass apart; times are added to `passes`.
    void drawPasses(std::vector<PassTimes>& passes);

private:
    template <typename Work>
    auto timed(const char* name, Work&& work);
    void finishOnce();

    std::vector<PhaseTime> phases;
    std::uint64_t heldBefore;
    Scene scene;
    Camera camera;
    ShadingPlan plan;
    Renderer renderer;
    DeviceScene deviceScene;
    std::uint64_t held = 0;
};

/// Triangles of all instances.
std::size_t triangleCount(const Scene& scene);
/// Calls that draw: one for all neighbouring instances of a primitive.
std::size_t drawCount(const ShadingPlan& plan);

} // namespace torrance
