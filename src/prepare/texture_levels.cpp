#include "prepare/texture_levels.h"

#include "core/parallel.h"
#include "prepare/word_codec.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>

namespace torrance {
namespace {

/// Level 0 of what is worked on at a time: what follows from it, down to kStripLevels below, stays in the cache.
constexpr int kStripLevels = 5;
/// Rows of strips that one task takes, so that its memory serves more than one.
constexpr std::size_t kStripsPerTask = 4;

/// The texels of the finer level under one of the coarser, along one axis.
struct Taps
{
    int first;
    int count;
    std::array<float, 3> weight;
};

/// Texel i of `coarse` covers [i, i + 1] * fine / coarse of the finer ones.
Taps tapsOf(int i, int fine, int coarse)
{
    if (fine == 1)
        return {0, 1, {1.0f}};
    if (fine % 2 == 0)
        return {2 * i, 2, {0.5f, 0.5f}};
    const float whole = static_cast<float>(fine);
    return {2 * i,
            3,
            {static_cast<float>(coarse - i) / whole, static_cast<float>(coarse) / whole,
             static_cast<float>(i + 1) / whole}};
}

/// Adds `weight` of a row of the finer level to one of the coarser.
void addRow(const Float4* fine, int fineWidth, float weight, Float4* coarse, int width)
{
    if (fineWidth % 2 == 0) { // the common case, without its taps
        const Float4 factor = splat(0.5f * weight);
        for (int x = 0; x < width; ++x)
            coarse[x] += factor * (fine[2 * x] + fine[2 * x + 1]);
        return;
    }
    for (int x = 0; x < width; ++x) {
        const Taps columns = tapsOf(x, fineWidth, width);
        Float4 sum = splat(0.0f);
        for (int i = 0; i < columns.count; ++i)
            sum += columns.weight[static_cast<std::size_t>(i)] * fine[columns.first + i];
        coarse[x] += weight * sum;
    }
}

/// The stored texels of row y; what has to be put together is, in `scratch`.
using CodeRows = std::function<const std::byte*(int y, std::byte* scratch)>;

struct Source
{
    int width;
    int height;
    const TexelCodec& codec;
    CodeRows row;

    std::size_t rowBytes() const { return static_cast<std::size_t>(width) * codec.codeBytes; }
    int widthOf(int level) const { return std::max(1, width >> level); }
    int heightOf(int level) const { return std::max(1, height >> level); }
};

/// Means of some level, where one strip leaves them for the levels below.
struct MeanRows
{
    int level;
    std::vector<Float4> texels;
};

/// Works out some rows of the levels `base` to `last` of a picture, each from as few of the level above as it needs,
/// and each once: three of a level are kept, the most that one of the next reads.
class Strip
{
public:
    /// `above` has the means of level `base` where that is not the picture itself; those of `last` go to `below`.
    Strip(const Source& picture, std::span<const LevelMemory> memory, const MeanRows* above, int lastLevel,
          MeanRows* below)
        : source(picture), levels(memory), given(above), base(above ? above->level : 0), last(lastLevel),
          result(below), scratch{std::vector<std::byte>(picture.rowBytes()), std::vector<std::byte>(picture.rowBytes())}
    {
        for (int level = base; level <= last; ++level)
            kept.push_back({.number = {-1, -1, -1},
                            .texels = std::vector<Float4>(kKept * static_cast<std::size_t>(source.widthOf(level)))});
    }

    /// Rows [first, end) of the last level, and of the others those that no other strip writes.
    void write(int first, int end)
    {
        for (int level = base; level <= last; ++level)
            endOfOwn.at(index(level)) = end == source.heightOf(last) ? source.heightOf(level) : end << (last - level);
        if (last == 0)
            for (int y = first; y < end; ++y)
                store(y, source.row(y, scratch[0].data()));
        else
            for (int y = first; y < end; ++y)
                means(last, y);
    }

private:
    static constexpr std::size_t kKept = 3;

    struct Kept
    {
        std::array<int, kKept> number;
        std::vector<Float4> texels;
    };

    std::size_t index(int level) const { return static_cast<std::size_t>(level - base); }

    void store(int y, const std::byte* codes) const
    {
        if (levels[0].texels && y < endOfOwn[0])
            source.codec.store(codes, static_cast<std::size_t>(source.width),
                               levels[0].texels + static_cast<std::size_t>(y) * levels[0].rowPitch);
    }

    void encode(int level, int y, const Float4* row) const
    {
        if (y >= endOfOwn[index(level)])
            return;
        const auto width = static_cast<std::size_t>(source.widthOf(level));
        const auto number = static_cast<std::size_t>(level);
        if (levels[number].texels)
            source.codec.encode(row, width,
                                levels[number].texels + static_cast<std::size_t>(y) * levels[number].rowPitch);
        if (result && level == result->level)
            std::copy_n(row, width, result->texels.data() + static_cast<std::size_t>(y) * width);
    }

    const Float4* means(int level, int y)
    {
        const auto width = static_cast<std::size_t>(source.widthOf(level));
        if (given && level == base)
            return given->texels.data() + static_cast<std::size_t>(y) * width;
        Kept& rows = kept[index(level)];
        const std::size_t place = static_cast<std::size_t>(y) % kKept;
        Float4* row = rows.texels.data() + place * width;
        if (rows.number[place] == y)
            return row;
        rows.number[place] = y;
        if (level == 0) {
            const std::byte* codes = source.row(y, scratch[0].data());
            store(y, codes);
            source.codec.decode(codes, width, row);
            return row;
        }
        if (level == 1 && source.width % 2 == 0 && source.height % 2 == 0)
            halve(y, row);
        else
            reduce(level, y, row);
        encode(level, y, row);
        return row;
    }

    void halve(int y, Float4* row)
    {
        const std::byte* upper = source.row(2 * y, scratch[0].data());
        const std::byte* lower = source.row(2 * y + 1, scratch[1].data());
        store(2 * y, upper);
        store(2 * y + 1, lower);
        source.codec.halve(upper, lower, static_cast<std::size_t>(source.widthOf(1)), row);
    }

    void reduce(int level, int y, Float4* row)
    {
        const int width = source.widthOf(level);
        std::fill_n(row, width, splat(0.0f));
        const Taps rows = tapsOf(y, source.heightOf(level - 1), source.heightOf(level));
        for (int i = 0; i < rows.count; ++i)
            addRow(means(level - 1, rows.first + i), source.widthOf(level - 1),
                   rows.weight[static_cast<std::size_t>(i)], row, width);
    }

    const Source& source;
    std::span<const LevelMemory> levels;
    const MeanRows* given;
    const int base, last;
    MeanRows* result;
    std::array<std::vector<std::byte>, 2> scratch;
    std::vector<Kept> kept;                       // by level from base
    std::array<int, kStripLevels * 4> endOfOwn{}; // by level from base
};

/// Sources of one size, each of which writes its part of every texel, in their order.
void write(std::span<const Source> sources, std::span<const LevelMemory> levels)
{
    const Source& any = sources.front();
    assert(!levels.empty() && levels.size() <= static_cast<std::size_t>(mipCount(any.width, any.height)));
    const int last = static_cast<int>(levels.size()) - 1, top = std::min(last, kStripLevels);
    std::vector<MeanRows> between(sources.size(), {.level = top, .texels = {}});
    for (MeanRows& means : between)
        if (top < last)
            means.texels.resize(static_cast<std::size_t>(any.widthOf(top)) *
                                static_cast<std::size_t>(any.heightOf(top)));
    const auto below = [&](std::size_t i) { return top < last ? &between[i] : nullptr; };
    const std::size_t strips = sources.size() > 1 ? 1 : kStripsPerTask; // texels stay in the cache from part to part
    parallelRanges(static_cast<std::size_t>(any.heightOf(top)), strips, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = 0; i < sources.size(); ++i)
            Strip(sources[i], levels, nullptr, top, below(i)).write(static_cast<int>(first), static_cast<int>(end));
    });
    for (std::size_t i = 0; i < sources.size() && top < last; ++i)
        Strip(sources[i], levels, below(i), last, nullptr).write(0, any.heightOf(last));
}

const std::byte* rowOf(const TextureImage& image, int y)
{
    return image.texels.data() +
           static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) * bytesPerTexel(image.format);
}

/// Channel `from` of a picture's row as channel `to` of texels of four codes each.
template <typename From, typename To>
void gatherCodes(const std::byte* row, std::size_t from, std::size_t width, std::size_t to, std::byte* texels)
{
    constexpr unsigned kScale = std::numeric_limits<To>::max() / std::numeric_limits<From>::max();
    const auto* const source = reinterpret_cast<const From*>(row) + from;
    auto* const target = reinterpret_cast<To*>(texels) + to;
    for (std::size_t x = 0; x < width; ++x)
        target[4 * x] = static_cast<To>(source[4 * x] * kScale);
}

void gatherChannel(const TextureImage* image, std::size_t from, int y, TexelFormat format, std::size_t width,
                   std::size_t to, std::byte* texels)
{
    using Byte = std::uint8_t;
    using Word = std::uint16_t;
    constexpr std::array<Byte, 4> kOnes = {0xff, 0xff, 0xff, 0xff};
    if (!image) {
        for (std::size_t x = 0; x < width; ++x)
            std::memcpy(texels + (4 * x + to) * bytesPerTexel(format) / 4, kOnes.data(), bytesPerTexel(format) / 4);
        return;
    }
    assert(image->width == static_cast<int>(width));
    const std::byte* const row = rowOf(*image, y);
    if (format == TexelFormat::rgba8)
        gatherCodes<Byte, Byte>(row, from, width, to, texels);
    else if (image->format == TexelFormat::rgba8)
        gatherCodes<Byte, Word>(row, from, width, to, texels);
    else
        gatherCodes<Word, Word>(row, from, width, to, texels);
}

/// Rows of what `pictures` put together; they must outlive it.
CodeRows gatheredRows(const ChannelPictures& pictures, TexelFormat format)
{
    const auto width = static_cast<std::size_t>(pictures.any().width);
    return [&pictures, format, width](int y, std::byte* scratch) {
        for (std::size_t c = 0; c < pictures.images.size(); ++c)
            gatherChannel(pictures.images[c], static_cast<std::size_t>(pictures.channels[c]), y, format, width, c,
                          scratch);
        return static_cast<const std::byte*>(scratch);
    };
}

} // namespace

TexelStorage storageOf(TexelFormat format, const MipRule& rule)
{
    return texelCodec(format, rule).storage;
}

void writeLevels(const TextureImage& image, const MipRule& rule, std::span<const LevelMemory> levels)
{
    const auto width = static_cast<std::size_t>(image.width);
    CodeRows row = [&](int y, std::byte*) { return rowOf(image, y); };
    if (rule.lengthInAlpha)
        row = [&](int y, std::byte* scratch) {
            unitNormals(image.format, rowOf(image, y), width, scratch);
            return static_cast<const std::byte*>(scratch);
        };
    const Source source = {image.width, image.height, texelCodec(image.format, rule), std::move(row)};
    write({&source, 1}, levels);
}

bool ChannelPictures::empty() const
{
    return std::ranges::all_of(images, [](const TextureImage* image) { return image == nullptr; });
}

const TextureImage& ChannelPictures::any() const
{
    return **std::ranges::find_if(images, [](const TextureImage* image) { return image != nullptr; });
}

TexelFormat ChannelPictures::format() const
{
    const bool wide =
        std::ranges::any_of(images, [](const TextureImage* i) { return i && i->format == TexelFormat::rgba16; });
    return wide ? TexelFormat::rgba16 : TexelFormat::rgba8;
}

void writePackedLevels(const ChannelPictures& pictures, const MipRule& rule, std::span<const LevelMemory> levels)
{
    assert(!rule.lengthInAlpha);
    const TextureImage& any = pictures.any();
    const TexelFormat format = pictures.format();
    const Source source = {any.width, any.height, texelCodec(format, rule), gatheredRows(pictures, format)};
    write({&source, 1}, levels);
}

void writeWordLevels(const WordPictures& parts, std::span<const LevelMemory> levels)
{
    std::vector<Source> sources;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!parts[i].empty()) {
            assert(parts[i].format() == TexelFormat::rgba8);
            const TextureImage& any = parts[i].any();
            sources.push_back({any.width, any.height, wordCodec(static_cast<WordPart>(i), sources.empty()),
                               gatheredRows(parts[i], TexelFormat::rgba8)});
        }
    write(sources, levels);
}

} // namespace torrance
