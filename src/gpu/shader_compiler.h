// GLSL to SPIR-V with glslang in process, and what the shader binds.
#pragma once

#include "gpu/shader_source.h"
#include "gpu/vulkan.h"

#include <cstdint>
#include <vector>

namespace torrance::gpu {

struct ShaderBinding
{
    std::uint32_t binding = 0;
    vk::DescriptorType type = vk::DescriptorType::eStorageBuffer;

    bool operator==(const ShaderBinding&) const = default;
};

struct CompiledShader
{
    std::string name; // the entry
    vk::ShaderStageFlagBits stage = vk::ShaderStageFlagBits::eFragment;
    std::vector<std::uint32_t> words;
    std::vector<ShaderBinding> bindings; // of set 0, those the shader uses, sorted
};

/// Throws Error (usage) with glslang's first message, file and line. Thread-safe.
CompiledShader compileShader(const ShaderSource& source);

/// glslang's version, part of every cache key.
std::string shaderCompilerVersion();

} // namespace torrance::gpu
