#include "passes/fullscreen.h"

namespace torrance {

void drawFullscreen(const gpu::Commands& commands, const gpu::Pipeline& pipeline, const gpu::Bindings& bindings)
{
    commands.buffer.setCullMode(vk::CullModeFlagBits::eNone);
    commands.buffer.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline.handle);
    bindings.push(commands.buffer, pipeline);
    commands.buffer.draw(3, 1, 0, 0);
}

} // namespace torrance
