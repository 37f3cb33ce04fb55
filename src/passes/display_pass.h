// A drawn picture in the codes of a screen: exposure, tone curve and transfer curve, as image/display.h has them for
// files.
#pragma once

#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "gpu/shader_library.h"
#include "image/display.h"

#include <map>
#include <string>

namespace torrance {

/// Where a picture appears and what its numbers are multiplied with and moved by first (1 and 0 for colours).
struct DisplayPlace
{
    ivec2 origin = ivec2(0); // of its first pixel in the target
    ivec2 size = ivec2(0);   // of the part that is drawn, from there on
    int skip = 0;            // of its columns at the left, which stay as they are
    double factor = 1.0;
    double offset = 0.0;
};

class DisplayPass
{
public:
    /// For targets of 8-bit codes in this format.
    DisplayPass(const gpu::Device& device, gpu::ShaderLibrary& shaders, vk::Format format);

    /// Inside a rendering of such a target; `source`, which is 4 floats a pixel, has been noted as sampled before it.
    /// Codes lie within 1/255 of a file's. The buffer is what the pass reads: kept until the commands have run.
    /// `settings.alpha` has no meaning here: a chequerboard is seen where nothing covers a pixel.
    gpu::Buffer draw(gpu::Commands& commands, const gpu::DeviceImage& source, const DisplayPlace& place,
                     const DisplaySettings& settings);

private:
    const gpu::Pipeline& pipeline(const DisplaySettings& settings);

    const gpu::Device& device;
    gpu::ShaderLibrary& shaders;
    vk::Format format;
    vk::raii::Sampler sampler;
    std::map<std::string, gpu::Pipeline> pipelines; // by the curves' ids
};

} // namespace torrance
