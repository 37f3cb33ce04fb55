#include "gpu/pipeline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <stdexcept>

namespace torrance::gpu {
namespace {

// lavapipe of Mesa 22.3 notes the values of uniform blocks that branches depend on, so as to inline them, and where a
// shader has four blocks writes past the end of its notes: lvp_inline_uniforms.c takes rows of 4 numbers to be 32
// apart.
constexpr std::ptrdiff_t kMostUniformBlocks = 3;

std::vector<ShaderBinding> mergedBindings(const CompiledShader& vertex, const CompiledShader* fragment)
{
    std::vector<ShaderBinding> all = vertex.bindings;
    for (const ShaderBinding& binding : fragment ? fragment->bindings : std::vector<ShaderBinding>())
        if (std::ranges::find(all, binding) == all.end())
            all.push_back(binding);
    std::ranges::sort(all, {}, &ShaderBinding::binding);
    assert(std::ranges::count(all, vk::DescriptorType::eUniformBuffer, &ShaderBinding::type) <= kMostUniformBlocks);
    return all;
}

vk::raii::DescriptorSetLayout makeSetLayout(const Device& device, const std::vector<ShaderBinding>& bindings)
{
    std::vector<vk::DescriptorSetLayoutBinding> list;
    for (const ShaderBinding& binding : bindings)
        list.push_back({.binding = binding.binding,
                        .descriptorType = binding.type,
                        .descriptorCount = 1,
                        .stageFlags = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment});
    return {device.handle,
            vk::DescriptorSetLayoutCreateInfo{.flags = vk::DescriptorSetLayoutCreateFlagBits::ePushDescriptorKHR,
                                              .bindingCount = static_cast<std::uint32_t>(list.size()),
                                              .pBindings = list.data()}};
}

vk::PipelineDepthStencilStateCreateInfo depthState(DepthUse use, StencilUse stencil)
{
    const bool writes = stencil == StencilUse::write;
    const vk::StencilOpState face = {.failOp = vk::StencilOp::eKeep,
                                     .passOp = writes ? vk::StencilOp::eReplace : vk::StencilOp::eKeep,
                                     .depthFailOp = vk::StencilOp::eKeep,
                                     .compareOp = writes ? vk::CompareOp::eAlways : vk::CompareOp::eEqual,
                                     .compareMask = 0xff,
                                     .writeMask = writes ? 0xffu : 0u};
    const bool tests = use != DepthUse::none;
    // Reversed depth: 1 at the near plane, 0 at infinity and where nothing was drawn.
    return {.depthTestEnable = tests,
            .depthWriteEnable = use == DepthUse::testAndWrite,
            .depthCompareOp = use == DepthUse::equal ? vk::CompareOp::eEqual : vk::CompareOp::eGreaterOrEqual,
            .stencilTestEnable = stencil != StencilUse::none,
            .front = face,
            .back = face};
}

vk::PipelineColorBlendAttachmentState blendState(Blend blend)
{
    using Factor = vk::BlendFactor;
    const Factor source = blend == Blend::weighted ? Factor::eConstantColor : Factor::eOne;
    const Factor target = blend == Blend::premultiplied ? Factor::eOneMinusSrcAlpha : Factor::eOne;
    return {.blendEnable = blend != Blend::replace,
            .srcColorBlendFactor = source,
            .dstColorBlendFactor = target,
            .colorBlendOp = vk::BlendOp::eAdd,
            .srcAlphaBlendFactor = source,
            .dstAlphaBlendFactor = target,
            .alphaBlendOp = vk::BlendOp::eAdd,
            .colorWriteMask = vk::ColorComponentFlagBits::eR | vk::ColorComponentFlagBits::eG |
                              vk::ColorComponentFlagBits::eB | vk::ColorComponentFlagBits::eA};
}

vk::raii::ShaderModule makeModule(const Device& device, const CompiledShader& shader)
{
    vk::raii::ShaderModule module(device.handle,
                                  vk::ShaderModuleCreateInfo{.codeSize = shader.words.size() * sizeof(std::uint32_t),
                                                             .pCode = shader.words.data()});
    device.name(module, shader.name);
    return module;
}

// Specialization constants 0, 1, ... of four bytes each.
struct Specialization
{
    std::vector<vk::SpecializationMapEntry> entries;
    vk::SpecializationInfo info;

    explicit Specialization(const std::vector<std::uint32_t>& constants)
    {
        for (std::uint32_t i = 0; i < constants.size(); ++i)
            entries.push_back({.constantID = i, .offset = i * 4, .size = 4});
        info = {.mapEntryCount = static_cast<std::uint32_t>(entries.size()),
                .pMapEntries = entries.data(),
                .dataSize = constants.size() * 4,
                .pData = constants.data()};
    }
};

vk::raii::Pipeline makeHandle(const Device& device, const CompiledShader& vertex, const CompiledShader* fragment,
                              const PipelineDescription& description, const vk::raii::PipelineLayout& layout)
{
    const vk::raii::ShaderModule vertexModule = makeModule(device, vertex),
                                 fragmentModule =
                                     fragment ? makeModule(device, *fragment) : vk::raii::ShaderModule(nullptr);
    const Specialization specialization(description.constants);
    const std::array stages = {vk::PipelineShaderStageCreateInfo{
                                   .stage = vk::ShaderStageFlagBits::eVertex, .module = *vertexModule, .pName = "main"},
                               vk::PipelineShaderStageCreateInfo{.stage = vk::ShaderStageFlagBits::eFragment,
                                                                 .module = *fragmentModule,
                                                                 .pName = "main",
                                                                 .pSpecializationInfo = &specialization.info}};
    std::vector<vk::VertexInputBindingDescription> bindings;
    std::vector<vk::VertexInputAttributeDescription> attributes;
    for (const VertexStream& stream : description.streams) {
        const auto index = static_cast<std::uint32_t>(bindings.size());
        bindings.push_back(
            {.binding = index,
             .stride = stream.stride,
             .inputRate = stream.perInstance ? vk::VertexInputRate::eInstance : vk::VertexInputRate::eVertex});
        attributes.push_back({.location = stream.location, .binding = index, .format = stream.format});
    }
    const vk::PipelineVertexInputStateCreateInfo vertexInput = {
        .vertexBindingDescriptionCount = static_cast<std::uint32_t>(bindings.size()),
        .pVertexBindingDescriptions = bindings.data(),
        .vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size()),
        .pVertexAttributeDescriptions = attributes.data()};
    const vk::PipelineInputAssemblyStateCreateInfo assembly = {.topology = description.topology};
    const vk::PipelineViewportStateCreateInfo viewport = {.viewportCount = 1, .scissorCount = 1};
    const vk::PipelineRasterizationStateCreateInfo raster = {.polygonMode = vk::PolygonMode::eFill, .lineWidth = 1.0f};
    const vk::PipelineMultisampleStateCreateInfo samples = {
        .rasterizationSamples = description.samples,
        .sampleShadingEnable = fragment && description.samples != vk::SampleCountFlagBits::e1,
        .minSampleShading = 1.0f};
    const auto depth = depthState(description.depth, description.stencil);
    const std::vector blends(description.colorFormats.size(), blendState(description.blend));
    const vk::PipelineColorBlendStateCreateInfo blend = {.attachmentCount = static_cast<std::uint32_t>(blends.size()),
                                                         .pAttachments = blends.data()};
    std::vector dynamics = {vk::DynamicState::eViewport, vk::DynamicState::eScissor, vk::DynamicState::eCullMode,
                            vk::DynamicState::eFrontFace};
    if (description.stencil != StencilUse::none)
        dynamics.push_back(vk::DynamicState::eStencilReference);
    if (description.blend == Blend::weighted)
        dynamics.push_back(vk::DynamicState::eBlendConstants);
    const vk::PipelineDynamicStateCreateInfo dynamic = {
        .dynamicStateCount = static_cast<std::uint32_t>(dynamics.size()), .pDynamicStates = dynamics.data()};
    const vk::PipelineRenderingCreateInfo rendering = {
        .colorAttachmentCount = static_cast<std::uint32_t>(description.colorFormats.size()),
        .pColorAttachmentFormats = description.colorFormats.data(),
        .depthAttachmentFormat = description.depthFormat.value_or(vk::Format::eUndefined),
        .stencilAttachmentFormat = description.depthFormat && hasStencil(*description.depthFormat)
                                       ? *description.depthFormat
                                       : vk::Format::eUndefined};
    vk::raii::Pipeline pipeline(device.handle, nullptr,
                                vk::GraphicsPipelineCreateInfo{.pNext = &rendering,
                                                               .stageCount = fragment ? 2u : 1u,
                                                               .pStages = stages.data(),
                                                               .pVertexInputState = &vertexInput,
                                                               .pInputAssemblyState = &assembly,
                                                               .pViewportState = &viewport,
                                                               .pRasterizationState = &raster,
                                                               .pMultisampleState = &samples,
                                                               .pDepthStencilState = &depth,
                                                               .pColorBlendState = &blend,
                                                               .pDynamicState = &dynamic,
                                                               .layout = *layout});
    device.name(pipeline, description.name);
    return pipeline;
}

Pipeline make(const Device& device, const CompiledShader& vertex, const CompiledShader* fragment,
              const PipelineDescription& description)
{
    Pipeline pipeline;
    pipeline.bindings = mergedBindings(vertex, fragment);
    pipeline.setLayout = makeSetLayout(device, pipeline.bindings);
    const vk::DescriptorSetLayout layout = *pipeline.setLayout;
    pipeline.layout = vk::raii::PipelineLayout(
        device.handle, vk::PipelineLayoutCreateInfo{.setLayoutCount = 1, .pSetLayouts = &layout});
    device.name(pipeline.setLayout, description.name);
    device.name(pipeline.layout, description.name);
    pipeline.handle = makeHandle(device, vertex, fragment, description, pipeline.layout);
    return pipeline;
}

} // namespace

Pipeline makePipeline(const Device& device, const CompiledShader& vertex, const CompiledShader& fragment,
                      const PipelineDescription& description)
{
    return make(device, vertex, &fragment, description);
}

Pipeline makeDepthPipeline(const Device& device, const CompiledShader& vertex, const PipelineDescription& description)
{
    return make(device, vertex, nullptr, description);
}

Bindings::Item& Bindings::item(std::uint32_t binding)
{
    const auto found = std::ranges::find(items, binding, &Item::binding);
    if (found != items.end())
        return *found;
    items.push_back({binding, {}, {}});
    return items.back();
}

void Bindings::set(std::uint32_t binding, const Buffer& buffer, vk::DeviceSize offset, vk::DeviceSize range)
{
    item(binding).buffer = vk::DescriptorBufferInfo{.buffer = *buffer.handle, .offset = offset, .range = range};
}

void Bindings::set(std::uint32_t binding, const DeviceImage& image, const vk::raii::Sampler& sampler)
{
    item(binding).image = vk::DescriptorImageInfo{
        .sampler = *sampler,
        .imageView = *image.depthView ? *image.depthView : *image.view,
        .imageLayout = *image.depthView ? vk::ImageLayout::eDepthStencilReadOnlyOptimal // it may be tested meanwhile
                                        : vk::ImageLayout::eShaderReadOnlyOptimal};
}

void Bindings::push(const vk::raii::CommandBuffer& commands, const Pipeline& pipeline) const
{
    std::vector<vk::WriteDescriptorSet> writes;
    for (const ShaderBinding& binding : pipeline.bindings) {
        const auto found = std::ranges::find(items, binding.binding, &Item::binding);
        if (found == items.end())
            throw std::logic_error("binding " + std::to_string(binding.binding) + " of the pipeline was not set");
        const bool isImage = binding.type == vk::DescriptorType::eCombinedImageSampler;
        writes.push_back({.dstBinding = binding.binding,
                          .descriptorCount = 1,
                          .descriptorType = binding.type,
                          .pImageInfo = isImage ? &found->image : nullptr,
                          .pBufferInfo = isImage ? nullptr : &found->buffer});
    }
    if (!writes.empty())
        commands.pushDescriptorSetKHR(vk::PipelineBindPoint::eGraphics, *pipeline.layout, 0, writes);
}

} // namespace torrance::gpu
