#include "view/panel_renderer.h"

#include "passes/sampler.h"
#include "shaders/shared/bindings.h"

#include <algorithm>
#include <cstddef>
#include <imgui.h>
#include <set>

namespace torrance {
namespace {

gpu::Pipeline makePanelPipeline(const gpu::Device& device, gpu::ShaderLibrary& shaders, vk::Format format)
{
    constexpr auto kStride = static_cast<std::uint32_t>(sizeof(ImDrawVert));
    return gpu::makePipeline(device, shaders.get("passes/panels.vert", ""), shaders.get("passes/panels.frag", ""),
                             {.name = "panels",
                              .streams = {{.location = 0, .format = vk::Format::eR32G32Sfloat, .stride = kStride},
                                          {.location = 1, .format = vk::Format::eR32G32Sfloat, .stride = kStride},
                                          {.location = 2, .format = vk::Format::eR8G8B8A8Unorm, .stride = kStride}},
                              .colorFormats = {format},
                              .blend = gpu::Blend::premultiplied});
}

vk::raii::Sampler makePanelSampler(const gpu::Device& device)
{
    return makeSampler(device, {.wrapS = Wrap::clampToEdge, .wrapT = Wrap::clampToEdge, .mip = MipFilter::none}, 0.0f);
}

const gpu::DeviceImage& pictureOf(const ImDrawCmd& command)
{
    return *static_cast<const gpu::DeviceImage*>(command.GetTexID());
}

// All lists behind one another, as one buffer.
template <typename T>
gpu::Buffer gather(const gpu::Device& device, const ImDrawData& data, ImVector<T> ImDrawList::*items,
                   vk::BufferUsageFlags usage, const char* name)
{
    std::vector<std::byte> bytes;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImVector<T>& list = data.CmdLists[i]->*items;
        const auto view = std::as_bytes(std::span(list.Data, static_cast<std::size_t>(list.Size)));
        bytes.insert(bytes.end(), view.begin(), view.end());
    }
    return gpu::makeBuffer(device, bytes, usage, name);
}

// A part of the target; ImGui's coordinates may leave it.
std::optional<vk::Rect2D> scissorOf(const ImDrawCmd& command, const ImDrawData& data)
{
    const ImVec2 scale = data.FramebufferScale, from = data.DisplayPos;
    const float width = data.DisplaySize.x * scale.x, height = data.DisplaySize.y * scale.y;
    const float left = std::clamp((command.ClipRect.x - from.x) * scale.x, 0.0f, width);
    const float top = std::clamp((command.ClipRect.y - from.y) * scale.y, 0.0f, height);
    const float right = std::clamp((command.ClipRect.z - from.x) * scale.x, 0.0f, width);
    const float bottom = std::clamp((command.ClipRect.w - from.y) * scale.y, 0.0f, height);
    if (!(right > left) || !(bottom > top))
        return std::nullopt;
    return vk::Rect2D{{static_cast<std::int32_t>(left), static_cast<std::int32_t>(top)},
                      {static_cast<std::uint32_t>(right) - static_cast<std::uint32_t>(left),
                       static_cast<std::uint32_t>(bottom) - static_cast<std::uint32_t>(top)}};
}

} // namespace

gpu::DeviceImage uploadPanelPicture(const gpu::Device& device, int width, int height, std::span<const std::byte> codes,
                                    const char* name)
{
    gpu::DeviceImage image =
        gpu::makeImage(device,
                       {.width = static_cast<std::uint32_t>(width),
                        .height = static_cast<std::uint32_t>(height),
                        .format = vk::Format::eR8G8B8A8Unorm},
                       vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst, name);
    const gpu::Buffer staging = gpu::makeStagingBuffer(device, codes, name);
    gpu::Commands commands(device);
    gpu::copyToImage(commands, staging, image, 4);
    commands.submitAndWait();
    return image;
}

PanelRenderer::PanelRenderer(const gpu::Device& d, gpu::ShaderLibrary& shaders, vk::Format format)
    : device(d), sampler(makePanelSampler(d)), pipeline(makePanelPipeline(d, shaders, format))
{
    ImGuiIO& io = ImGui::GetIO();
    io.BackendRendererName = "torrance";
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    uploadFonts();
}

void PanelRenderer::uploadFonts()
{
    unsigned char* codes = nullptr;
    int width = 0, height = 0;
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.GetTexDataAsRGBA32(&codes, &width, &height);
    const std::size_t bytes = std::size_t(width) * std::size_t(height) * 4;
    fonts = uploadPanelPicture(device, width, height, std::as_bytes(std::span(codes, bytes)), "fonts");
    atlas.SetTexID(&fonts);
}

void PanelRenderer::use(gpu::Commands& commands, const ImDrawData& data) const
{
    std::set<const gpu::DeviceImage*> pictures;
    for (int i = 0; i < data.CmdListsCount; ++i)
        for (const ImDrawCmd& command : data.CmdLists[i]->CmdBuffer)
            pictures.insert(&pictureOf(command));
    std::vector<gpu::ImageUse> uses;
    for (const gpu::DeviceImage* picture : pictures)
        uses.push_back(gpu::use(*picture, gpu::Access::sampled));
    commands.use(uses);
}

void PanelRenderer::draw(gpu::Commands& commands, const ImDrawData& data, std::vector<gpu::Buffer>& keep) const
{
    if (data.TotalIdxCount == 0)
        return;
    using Usage = vk::BufferUsageFlagBits;
    const vec2 scale = 2.0f / vec2(data.DisplaySize.x, data.DisplaySize.y);
    const vec4 block(scale, -1.0f - data.DisplayPos.x * scale.x, -1.0f - data.DisplayPos.y * scale.y);
    gpu::Buffer place =
        gpu::makeBuffer(device, std::as_bytes(std::span(&block, 1)), Usage::eUniformBuffer, "panels: place");
    gpu::Buffer vertexBuffer = gather(device, data, &ImDrawList::VtxBuffer, Usage::eVertexBuffer, "panels: vertices");
    gpu::Buffer indexBuffer = gather(device, data, &ImDrawList::IdxBuffer, Usage::eIndexBuffer, "panels: indices");
    const vk::Buffer vertices = *vertexBuffer.handle;
    commands.buffer.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline.handle);
    commands.buffer.setCullMode(vk::CullModeFlagBits::eNone);
    commands.buffer.bindVertexBuffers(0, {vertices, vertices, vertices},
                                      {offsetof(ImDrawVert, pos), offsetof(ImDrawVert, uv), offsetof(ImDrawVert, col)});
    static_assert(sizeof(ImDrawIdx) == 2);
    commands.buffer.bindIndexBuffer(*indexBuffer.handle, 0, vk::IndexType::eUint16);
    int firstVertex = 0;
    std::uint32_t firstIndex = 0;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const std::optional<vk::Rect2D> scissor = scissorOf(command, data);
            if (!scissor)
                continue;
            gpu::Bindings bindings;
            bindings.set(shared::kBindFrame, place);
            bindings.set(shared::kBindSource, pictureOf(command), sampler);
            bindings.push(commands.buffer, pipeline);
            commands.buffer.setScissor(0, *scissor);
            commands.buffer.drawIndexed(command.ElemCount, 1, firstIndex + command.IdxOffset,
                                        firstVertex + static_cast<int>(command.VtxOffset), 0);
        }
        firstVertex += list.VtxBuffer.Size;
        firstIndex += static_cast<std::uint32_t>(list.IdxBuffer.Size);
    }
    for (gpu::Buffer* buffer : {&place, &vertexBuffer, &indexBuffer})
        keep.push_back(std::move(*buffer));
}

} // namespace torrance
