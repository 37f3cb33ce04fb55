#include "study/bench_item.h"

#include "files/image_encoders.h"
#include "image/display.h"
#include "study/timed_frame.h"

#include <algorithm>

namespace torrance {

template <typename Work>
auto BenchItem::timed(const char* name, Work&& work)
{
    struct Stopwatch
    {
        ~Stopwatch() { phases.push_back({name, timeUse() - start}); }
        std::vector<PhaseTime>& phases;
        const char* name;
        TimeUse start;
    };
    const Stopwatch watch = {phases, name, timeUse()};
    return work();
}

BenchItem::BenchItem(const gpu::Device& device, gpu::ShaderLibrary& shaders, const std::filesystem::path& cacheFolder,
                     const BenchSource& source)
    : heldBefore(settledMemoryUse().own), scene(timed("load", source.load)), camera(source.camera(scene)),
      plan(timed("plan", [&] { return makePlan(scene, source.settings); })), renderer(device, shaders, cacheFolder),
      deviceScene(timed("upload", [&] { return renderer.upload(scene, plan); }))
{
    timed("first draw", [&] { drawFrame(); });
    timed("second draw", [&] { drawFrame(); });
    finishOnce();
    const std::uint64_t now = settledMemoryUse().own;
    held = now - std::min(now, heldBefore);
}

// The way of a picture from the device to bytes, as render goes it.
void BenchItem::finishOnce()
{
    const Settings& settings = plan.settings;
    TimeUse drawn;
    const Picture picture = renderer.render(deviceScene, camera, [&](int, int) { drawn = timeUse(); });
    phases.push_back({"read back", timeUse() - drawn});
    const Image display = timed("display transform", [&] {
        return toDisplay(picture.color, {.tone = findToneCurve(settings.methods.tone),
                                         .transfer = findTransferCurve(settings.methods.transfer)});
    });
    constexpr int kBits = 8;
    timed("encode", [&] { return encodePng(display, kBits); });
}

TimeUse BenchItem::drawFrame()
{
    return timeOfFrame(renderer, deviceScene, camera);
}

void BenchItem::drawPasses(std::vector<PassTimes>& passes)
{
    renderer.drawFrame(deviceScene, camera, [&](const char* name, const std::function<void()>& run) {
        const TimeUse start = timeUse();
        run();
        const TimeUse use = timeUse() - start;
        auto found = std::ranges::find(passes, name, &PassTimes::name);
        if (found == passes.end())
            found = passes.insert(found, {name, {}, {}});
        found->processor.push_back(use.processor);
        found->wall.push_back(use.wall);
    });
}

std::size_t triangleCount(const Scene& scene)
{
    std::size_t count = 0;
    for (const Instance& instance : scene.instances) {
        const Primitive& primitive = scene.primitives[static_cast<std::size_t>(instance.primitive)];
        if (primitive.topology == Topology::triangles)
            count += primitive.indices.size() / 3;
    }
    return count;
}

std::size_t drawCount(const ShadingPlan& plan)
{
    std::size_t count = 0;
    for (const auto* list : {&plan.batches, &plan.blended})
        for (const Batch& batch : *list)
            count += batch.draws.size();
    return count;
}

} // namespace torrance
