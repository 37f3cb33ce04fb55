// How the texels of a file become numbers that may be averaged, and how both lie on the device: row by row.
#pragma once

#include "math/float4.h"
#include "prepare/mips.h"
#include "scene/texture.h"

#include <cstddef>

namespace torrance {

/// Four channels of a texel on the device.
enum class TexelStorage
{
    unorm8,
    unorm16,
    half,
    single,
    words, // of all of a material's textures: shaders/shared/texel_words.h
};

constexpr std::size_t bytesPerTexel(TexelStorage storage)
{
    constexpr std::size_t kBytes[] = {4, 8, 8, 16, 16};
    return kBytes[static_cast<std::size_t>(storage)];
}

/// Colours become linear light before they are sampled: of 8 bits a half, within 2^-12 of the exact curve, of 16 bits a
/// float; so do their means. Normals lie in 16 bits, and their means between the file's codes. Everything else lies as
/// it is stored.
struct TexelCodec
{
    TexelStorage storage;
    std::size_t codeBytes; // of a texel in the file

    /// `count` texels from the file as numbers.
    void (*decode)(const std::byte* codes, std::size_t count, Float4* values);
    /// Means under 2 x 2 of them: the sums of decode() without its round trip through memory.
    void (*halve)(const std::byte* upper, const std::byte* lower, std::size_t count, Float4* means);
    /// Texels from the file as the device has them.
    void (*store)(const std::byte* codes, std::size_t count, std::byte* texels);
    /// Means as the device has them.
    void (*encode)(const Float4* means, std::size_t count, std::byte* texels);
};

/// For texels as they come from the file; with MipRule::lengthInAlpha for those of unitNormals().
const TexelCodec& texelCodec(TexelFormat format, const MipRule& rule);

/// Normals of a file in 16 bits a channel, unit, with an alpha of 1, their length: where the lengths of means matter, 8
/// bits would round those near 1 by more than they differ.
void unitNormals(TexelFormat format, const std::byte* codes, std::size_t count, std::byte* wide);

} // namespace torrance
