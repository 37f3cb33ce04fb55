// The shaders of this installation, compiled when they are first asked for and kept on disk by the hash of their text.
#pragma once

#include "core/disk_cache.h"
#include "gpu/shader_compiler.h"

#include <filesystem>

namespace torrance::gpu {

class ShaderLibrary
{
public:
    /// `root` holds the shaders folder's content. An empty cache folder: every shader is compiled anew.
    ShaderLibrary(std::filesystem::path root, const std::filesystem::path& cacheFolder);

    /// `entry` relative to the root, `selected` = the text of selected.glsl.
    CompiledShader get(const std::string& entry, const std::string& selected);

    /// The text of an entry and of all that it includes; get() of it, changed, is another shader.
    ShaderSource gather(const std::string& entry, const std::string& selected) const;
    CompiledShader get(const ShaderSource& source);

    std::size_t compiledCount() const { return compiled; } // how many were not in the cache

private:
    std::filesystem::path root;
    DiskCache cache;
    std::size_t compiled = 0;
};

} // namespace torrance::gpu
