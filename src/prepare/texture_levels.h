// Textures on their way to the device: all levels of a picture, as the device has them, written where it keeps them.
#pragma once

#include "prepare/mips.h"
#include "prepare/texel_codec.h"

#include <array>
#include <span>

namespace torrance {

/// Where a level goes: rows of texels one after the other, `rowPitch` bytes from one to the next. Without texels it is
/// one that nobody reads: passed through, not kept.
struct LevelMemory
{
    std::byte* texels = nullptr;
    std::size_t rowPitch = 0;
};

/// How the device has a picture that is read by this rule.
TexelStorage storageOf(TexelFormat format, const MipRule& rule);

/// Writes level 0 and as many more as `levels` has room for, at most mipCount(). Level k is max(1, floor(size / 2^k))
/// texels wide and high. Rows are spread over all cores; no level exists in memory of ours.
///
/// A texel is the exact mean over the area that it covers: where a side is odd, three texels weigh in, so that nothing
/// moves (Guthe & Heckbert, Non-Power-of-Two Mipmap Creation, 2005). Means are carried on in float from level to level;
/// what the device gets is rounded to the codes that the file could hold.
///
/// Normals are averaged and made unit again: the lengths, which stored 8-bit channels hold to a few per cent only, are
/// not used in shading, and short vectors would be rounded by whole degrees. Opposite normals that cancel give (0, 0,
/// 1).
void writeLevels(const TextureImage& image, const MipRule& rule, std::span<const LevelMemory> levels);

/// Channels of several pictures of one size as one: `images[c]`, null where nothing reads the channel (it is 1 then),
/// and which of its channels. Where one has 16 bits, all are read as 16: k * 257 is the same fraction.
struct ChannelPictures
{
    std::array<const TextureImage*, 4> images{};
    std::array<int, 4> channels = {0, 1, 2, 3};

    bool empty() const;
    const TextureImage& any() const;
    TexelFormat format() const;
};

/// As writeLevels() does with a picture that somebody has put together before.
void writePackedLevels(const ChannelPictures& pictures, const MipRule& rule, std::span<const LevelMemory> levels);

/// Of texel words, by WordPart (word_codec.h).
using WordPictures = std::array<ChannelPictures, 3>;

/// Texel words (shaders/shared/texel_words.h) of pictures of 8 bits and one size, each with three channels and a
/// scalar: base colour and metallic, normal and roughness, emission and occlusion. What is null is not read.
void writeWordLevels(const WordPictures& parts, std::span<const LevelMemory> levels);

} // namespace torrance
