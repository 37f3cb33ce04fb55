// Draws Dear ImGui's lists of triangles: its own renderer of 1.86 knows neither pictures in panels nor dynamic
// rendering.
#pragma once

#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "gpu/shader_library.h"

#include <optional>
#include <vector>

struct ImDrawData;

namespace torrance {

class PanelRenderer
{
public:
    /// For targets of this format. Needs a current ImGui context; its fonts are uploaded.
    PanelRenderer(const gpu::Device& device, gpu::ShaderLibrary& shaders, vk::Format format);

    /// Makes the font's picture anew, after fonts were added or scaled.
    void uploadFonts();

    /// Notes what the lists sample. Before the rendering in which they are drawn.
    void use(gpu::Commands& commands, const ImDrawData& data) const;

    /// Inside a rendering of such a target. An ImTextureID is the address of a gpu::DeviceImage, 4 channels with
    /// straight alpha. Buffers that must be kept until the commands have run are added to `keep`.
    void draw(gpu::Commands& commands, const ImDrawData& data, std::vector<gpu::Buffer>& keep) const;

private:
    const gpu::Device& device;
    vk::raii::Sampler sampler;
    gpu::Pipeline pipeline;
    gpu::DeviceImage fonts;
};

/// A picture of 8-bit codes with straight alpha, to be shown in panels.
gpu::DeviceImage uploadPanelPicture(const gpu::Device& device, int width, int height, std::span<const std::byte> codes,
                                    const char* name);

} // namespace torrance
