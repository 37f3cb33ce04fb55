// A graphics pipeline for dynamic rendering with one push-descriptor set, whose layout comes from the shaders.
#pragma once

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "gpu/shader_compiler.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace torrance::gpu {

/// One attribute per stream: streams lie apart, so a feature that is not there changes no layout.
struct VertexStream
{
    std::uint32_t location = 0;
    vk::Format format = vk::Format::eR32G32B32Sfloat;
    std::uint32_t stride = 12;
    bool perInstance = false; // one element an instance, not a vertex
};

enum class DepthUse
{
    none,
    testAndWrite, // reversed: greater is nearer, and of surfaces at one depth the last that is drawn is seen
    testOnly,
    equal, // passes at the depth that lies there already: a surface drawn again, or 0 where nothing was drawn
};

enum class StencilUse
{
    none,
    write, // the reference, where a fragment passes the depth test
    equal, // passes where the reference lies there already
};

enum class Blend
{
    replace,
    premultiplied, // source + (1 - source alpha) * target
    weighted,      // source * constant + target; the constant is dynamic state
};

struct PipelineDescription
{
    std::string name;
    std::vector<VertexStream> streams = {}; // binding = index in this list
    vk::PrimitiveTopology topology = vk::PrimitiveTopology::eTriangleList;
    std::vector<vk::Format> colorFormats = {};
    std::optional<vk::Format> depthFormat = {};
    DepthUse depth = DepthUse::none;
    StencilUse stencil = StencilUse::none; // the reference is dynamic state
    Blend blend = Blend::replace;
    vk::SampleCountFlagBits samples = vk::SampleCountFlagBits::e1; // of the targets; the fragment shader runs for each
    std::vector<std::uint32_t> constants = {}; // specialization constants 0, 1, ... of the fragment shader, as bits
};

struct Pipeline
{
    std::vector<ShaderBinding> bindings;
    vk::raii::DescriptorSetLayout setLayout = nullptr;
    vk::raii::PipelineLayout layout = nullptr;
    vk::raii::Pipeline handle = nullptr;
};

/// Viewport, scissor, cull mode and front face are dynamic state.
Pipeline makePipeline(const Device& device, const CompiledShader& vertex, const CompiledShader& fragment,
                      const PipelineDescription& description);

/// The same without a fragment shader: it draws depth alone.
Pipeline makeDepthPipeline(const Device& device, const CompiledShader& vertex, const PipelineDescription& description);

/// What a pass can bind; only the bindings that a pipeline has are pushed.
class Bindings
{
public:
    void set(std::uint32_t binding, const Buffer& buffer, vk::DeviceSize offset = 0,
             vk::DeviceSize range = VK_WHOLE_SIZE);
    void set(std::uint32_t binding, const DeviceImage& image, const vk::raii::Sampler& sampler);
    /// Throws std::logic_error where the pipeline has a binding that was not set.
    void push(const vk::raii::CommandBuffer& commands, const Pipeline& pipeline) const;

private:
    struct Item
    {
        std::uint32_t binding;
        vk::DescriptorBufferInfo buffer;
        vk::DescriptorImageInfo image;
    };
    Item& item(std::uint32_t binding);
    std::vector<Item> items;
};

} // namespace torrance::gpu
