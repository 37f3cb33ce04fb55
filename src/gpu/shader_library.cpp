#include "gpu/shader_library.h"

#include <cstring>
#include <optional>

namespace torrance::gpu {
namespace {

constexpr std::uintmax_t kMaxCacheBytes = 64u << 20; // some thousand shaders

// Cached form: number of bindings, bindings (number, type), words.
std::vector<std::byte> packed(const CompiledShader& shader)
{
    std::vector<std::uint32_t> words = {static_cast<std::uint32_t>(shader.bindings.size())};
    for (const ShaderBinding& binding : shader.bindings) {
        words.push_back(binding.binding);
        words.push_back(static_cast<std::uint32_t>(binding.type));
    }
    words.insert(words.end(), shader.words.begin(), shader.words.end());
    const auto bytes = std::as_bytes(std::span(words));
    return {bytes.begin(), bytes.end()};
}

std::optional<CompiledShader> unpacked(std::span<const std::byte> bytes, const std::string& entry)
{
    std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
    std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
    if (words.empty() || words.size() < 1 + std::size_t(2) * words[0])
        return std::nullopt;
    CompiledShader shader;
    shader.name = entry;
    shader.stage = entry.ends_with(".vert") ? vk::ShaderStageFlagBits::eVertex : vk::ShaderStageFlagBits::eFragment;
    std::size_t at = 1;
    for (std::uint32_t i = 0; i < words[0]; ++i, at += 2)
        shader.bindings.push_back({words[at], static_cast<vk::DescriptorType>(words[at + 1])});
    shader.words.assign(words.begin() + static_cast<std::ptrdiff_t>(at), words.end());
    return shader;
}

} // namespace

ShaderLibrary::ShaderLibrary(std::filesystem::path shaderRoot, const std::filesystem::path& cacheFolder)
    : root(std::move(shaderRoot)), cache(cacheFolder.empty() ? cacheFolder : cacheFolder / "spirv", kMaxCacheBytes)
{
}

CompiledShader ShaderLibrary::get(const std::string& entry, const std::string& selected)
{
    return get(gather(entry, selected));
}

ShaderSource ShaderLibrary::gather(const std::string& entry, const std::string& selected) const
{
    return gatherSource(root, entry, selected);
}

CompiledShader ShaderLibrary::get(const ShaderSource& source)
{
    const ContentHash sourceHash = source.hash();
    const ContentHash key =
        ContentHasher().add(sourceHash.high).add(sourceHash.low).add(shaderCompilerVersion()).finish();
    if (const auto bytes = cache.load(key))
        if (auto shader = unpacked(*bytes, source.entry))
            return std::move(*shader);
    CompiledShader shader = compileShader(source);
    ++compiled;
    cache.store(key, packed(shader));
    return shader;
}

} // namespace torrance::gpu
