#include "passes/display_pass.h"

#include "passes/fullscreen.h"
#include "passes/sampler.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/display.h"

#include <algorithm>

namespace torrance {
namespace {

std::string curveText(std::string_view slot, std::string_view macro, std::string_view id)
{
    std::string text = "#include \"image/";
    text.append(slot).append("/").append(id).append(".glsl\"\n#define ").append(macro).append(" ");
    return text.append(slot).append("_").append(id).append("\n");
}

} // namespace

DisplayPass::DisplayPass(const gpu::Device& d, gpu::ShaderLibrary& s, vk::Format f)
    : device(d), shaders(s), format(f), sampler(makePointSampler(d))
{
}

const gpu::Pipeline& DisplayPass::pipeline(const DisplaySettings& settings)
{
    const std::string selected =
        curveText("tone", "TONE", settings.tone->id) + curveText("transfer", "TRANSFER", settings.transfer->id);
    if (const auto found = pipelines.find(selected); found != pipelines.end())
        return found->second;
    return pipelines
        .emplace(selected, gpu::makePipeline(device, shaders.get("passes/fullscreen.vert", ""),
                                             shaders.get("passes/display.frag", selected),
                                             {.name = "display", .colorFormats = {format}}))
        .first->second;
}

gpu::Buffer DisplayPass::draw(gpu::Commands& commands, const gpu::DeviceImage& source, const DisplayPlace& place,
                              const DisplaySettings& settings)
{
    const float gain = exposureGain(settings);
    const shared::Display display = {.origin = place.origin,
                                     .gain = gain * static_cast<float>(place.factor),
                                     .shift = gain * static_cast<float>(place.offset)};
    gpu::Buffer block = gpu::makeBuffer(device, std::as_bytes(std::span(&display, 1)),
                                        vk::BufferUsageFlagBits::eUniformBuffer, "display");
    gpu::Bindings bindings;
    bindings.set(shared::kBindFrame, block);
    bindings.set(shared::kBindSource, source, sampler);
    const int skip = std::min(place.skip, place.size.x);
    commands.buffer.setScissor(
        0, vk::Rect2D{{place.origin.x + skip, place.origin.y},
                      {static_cast<std::uint32_t>(place.size.x - skip), static_cast<std::uint32_t>(place.size.y)}});
    drawFullscreen(commands, pipeline(settings), bindings);
    return block;
}

} // namespace torrance
