// A pass over the picture.
#pragma once

#include "gpu/commands.h"
#include "gpu/pipeline.h"

namespace torrance {

/// Records the one triangle of passes/fullscreen.vert inside a rendering, with the scissor as it is.
void drawFullscreen(const gpu::Commands& commands, const gpu::Pipeline& pipeline, const gpu::Bindings& bindings);

} // namespace torrance
