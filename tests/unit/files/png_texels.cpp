// The short way through PNG files, held against libpng on files of every kind and on damaged ones.
#include "files/png_texels.h"

#include "core/error.h"
#include "files/texture_file.h"
#include "libpng_oracle.h"
#include "mutations.h"
#include "png_bytes.h"

#include <gtest/gtest.h>
#include <zlib.h>

namespace torrance {
namespace {

using test::pngChunk;
using test::Random;

struct Layout
{
    int colorType;
    int bitDepth;
};

constexpr Layout kShort[] = {{0, 8}, {2, 8}, {3, 8}, {4, 8}, {6, 8}, {0, 16}, {2, 16}, {4, 16}, {6, 16}};
constexpr Layout kLong[] = {{0, 1}, {0, 2}, {0, 4}, {3, 1}, {3, 2}, {3, 4}};

std::size_t bitsPerPixel(const Layout& layout)
{
    constexpr std::size_t kChannels[] = {1, 0, 3, 1, 2, 0, 4};
    return kChannels[layout.colorType] * static_cast<std::size_t>(layout.bitDepth);
}

std::string headerChunk(std::uint32_t width, std::uint32_t height, const Layout& layout, int interlace = 0)
{
    std::string header;
    test::appendBigEndian(header, width);
    test::appendBigEndian(header, height);
    for (const int value : {layout.bitDepth, layout.colorType, 0, 0, interlace})
        header.push_back(static_cast<char>(value));
    return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header);
}

std::string paletteChunks(Random& random)
{
    std::string colors, alphas;
    for (int i = 0; i < 3 * 200; ++i) // fewer than 256: some indices lie outside
        colors.push_back(static_cast<char>(random.below(256)));
    for (int i = 0; i < 100; ++i)
        alphas.push_back(static_cast<char>(random.below(256)));
    return pngChunk("PLTE", colors) + pngChunk("tRNS", alphas);
}

/// Lines with the filter given, or any where it is negative. What is filtered needs no picture: every byte stands for
/// some.
std::string randomLines(Random& random, std::size_t height, std::size_t rowBytes, int filter)
{
    std::string lines;
    for (std::size_t y = 0; y < height; ++y) {
        lines.push_back(static_cast<char>(filter >= 0 ? filter : static_cast<int>(random.below(5))));
        for (std::size_t i = 0; i < rowBytes; ++i)
            lines.push_back(static_cast<char>(random.below(4) == 0 ? random.below(256) : 255 * random.below(2)));
    }
    return lines;
}

std::string zlibStream(const std::string& data, int level = 6)
{
    uLongf size = compressBound(data.size());
    std::string stream(size, '\0');
    compress2(reinterpret_cast<Bytef*>(stream.data()), &size, reinterpret_cast<const Bytef*>(data.data()), data.size(),
              level);
    stream.resize(size);
    return stream;
}

struct Picture
{
    Layout layout = {6, 8};
    std::uint32_t width = 1, height = 1;
    int filter = -1;

    std::string before(Random& random) const
    {
        return headerChunk(width, height, layout) + (layout.colorType == 3 ? paletteChunks(random) : "");
    }
    std::string stream(Random& random) const
    {
        const std::size_t rowBytes = (width * bitsPerPixel(layout) + 7) / 8;
        return zlibStream(randomLines(random, height, rowBytes, filter), static_cast<int>(random.below(10)));
    }
    std::string file(Random& random) const
    {
        return before(random) + pngChunk("IDAT", stream(random)) + pngChunk("IEND", "");
    }
};

/// By the program's way. The message of an Error is the result's problem.
test::LibpngResult decode(const std::string& bytes)
{
    test::LibpngResult result;
    try {
        result.image = decodeTexture(std::as_bytes(std::span(bytes)), "", "");
        result.read = true;
    } catch (const Error& error) {
        result.problem = error.what();
    }
    return result;
}

/// Whether the short way takes it, for pictures without palette.
bool isShort(const std::string& bytes, const Picture& picture)
{
    DecodeScratch scratch;
    std::vector<std::byte> texels(std::size_t(picture.width) * picture.height * 8);
    const PngLayout layout = {.width = picture.width,
                              .height = picture.height,
                              .bitDepth = picture.layout.bitDepth,
                              .colorType = picture.layout.colorType};
    const std::size_t idat = bytes.find("IDAT") - 4;
    return readPngTexels(layout, std::as_bytes(std::span(bytes)).subspan(idat), scratch, texels.data());
}

void expectLikeLibpng(const std::string& bytes, const std::string& what)
{
    const test::LibpngResult expected = test::readByLibpng(bytes), got = decode(bytes);
    ASSERT_EQ(got.read, expected.read) << what << ": " << got.problem << " / " << expected.problem;
    if (!expected.read) {
        EXPECT_NE(got.problem.find(expected.problem), std::string::npos) << what << ": " << got.problem;
        return;
    }
    EXPECT_EQ(got.image.width, expected.image.width) << what;
    EXPECT_EQ(got.image.height, expected.image.height) << what;
    EXPECT_EQ(got.image.format, expected.image.format) << what;
    EXPECT_TRUE(got.image.texels == expected.image.texels) << what;
}

TEST(PngTexels, AreThoseOfLibpng)
{
    Random random(1);
    for (const auto& layouts : {std::span<const Layout>(kShort), std::span<const Layout>(kLong)})
        for (const Layout& layout : layouts)
            for (int filter = -1; filter < 5; ++filter)
                for (const std::uint32_t width : {1u, 2u, 3u, 5u, 16u, 33u})
                    for (const std::uint32_t height : {1u, 2u, 7u}) {
                        const Picture picture = {layout, width, height, filter};
                        expectLikeLibpng(picture.file(random),
                                         std::to_string(layout.colorType) + "/" + std::to_string(layout.bitDepth) +
                                             ", filter " + std::to_string(filter) + ", " + std::to_string(width) + "x" +
                                             std::to_string(height));
                    }
}

TEST(PngTexels, ComeTheShortWayWhereNothingIsPeculiar)
{
    Random random(2);
    for (const Layout& layout : kShort)
        if (layout.colorType != 3) {
            const Picture picture = {layout, 13, 9};
            EXPECT_TRUE(isShort(picture.file(random), picture)) << layout.colorType << "/" << layout.bitDepth;
        }
    for (const Layout& layout : kLong) {
        const Picture picture = {layout, 13, 9};
        EXPECT_FALSE(isShort(picture.file(random), picture)) << layout.colorType << "/" << layout.bitDepth;
    }
}

// A column has as many bytes interlaced as not, in another order.
TEST(PngTexels, OfInterlacedFilesAreLeftToLibpng)
{
    Random random(8);
    for (const Layout& layout : kShort) {
        const Picture picture = {layout, 1, 8};
        const std::string file = headerChunk(1, 8, layout, 1) + (layout.colorType == 3 ? paletteChunks(random) : "") +
                                 pngChunk("IDAT", picture.stream(random)) + pngChunk("IEND", "");
        expectLikeLibpng(file, std::to_string(layout.colorType) + "/" + std::to_string(layout.bitDepth));
    }
}

TEST(PngTexels, ComeFromAnyNumberOfChunks)
{
    Random random(3);
    const Picture picture = {{2, 8}, 31, 17};
    const std::string stream = picture.stream(random);
    for (const std::size_t pieces : {2u, 3u, 50u}) {
        std::string file = picture.before(random);
        std::vector<std::size_t> cuts = {0, stream.size()};
        for (std::size_t i = 1; i < pieces; ++i)
            cuts.push_back(random.below(stream.size() + 1)); // some alike: empty chunks
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 1; i < cuts.size(); ++i)
            file += pngChunk("IDAT", stream.substr(cuts[i - 1], cuts[i] - cuts[i - 1]));
        file += pngChunk("tEXt", "of no effect") + pngChunk("IEND", "");
        EXPECT_TRUE(isShort(file, picture));
        expectLikeLibpng(file, std::to_string(pieces) + " chunks");
    }
}

// Each is refused by the short way and then judged by libpng: some are read, some are not.
TEST(PngTexels, OfPeculiarFilesAreLeftToLibpng)
{
    Random random(4);
    const Picture picture = {{6, 8}, 23, 40};
    const std::string before = picture.before(random), end = pngChunk("IEND", "");
    std::string lines = randomLines(random, 40, 23 * 4, -1);
    const std::string stream = zlibStream(lines);
    const auto idat = [&](std::string changed) { return pngChunk("IDAT", std::move(changed)); };
    const auto withByte = [&](std::size_t place, char value) {
        std::string changed = stream;
        changed[place] = value;
        return changed;
    };
    std::string smallWindow = stream; // claims 256 bytes; 31 divides the two header bytes again
    smallWindow[0] = '\x08';
    smallWindow[1] = static_cast<char>(31 - (0x0800 % 31));
    lines[0] = '\5';
    const std::pair<const char*, std::string> files[] = {
        {"a filter that does not exist", before + idat(zlibStream(lines)) + end},
        {"a window that is too small", before + idat(smallWindow) + end},
        {"a wrong Adler-32", before + idat(withByte(stream.size() - 1, static_cast<char>(stream.back() ^ 1))) + end},
        {"a preset dictionary", before + idat(withByte(1, static_cast<char>(stream[1] | 0x20))) + end},
        {"a method that is not deflate", before + idat(withByte(0, '\x77')) + end},
        {"bytes behind the stream", before + idat(stream + "more") + end},
        {"a line too many", before + idat(zlibStream(randomLines(random, 41, 23 * 4, -1))) + end},
        {"a line too few", before + idat(zlibStream(randomLines(random, 39, 23 * 4, -1))) + end},
        {"a stream without its end", before + idat(stream.substr(0, stream.size() - 4)) + end},
        {"no end", before + idat(stream)},
        {"an end with content", before + idat(stream) + pngChunk("IEND", "x")},
        {"a critical chunk behind the texels", before + idat(stream) + pngChunk("PLTE", "abc") + end},
        {"a chunk that nobody knows", before + idat(stream) + pngChunk("ABCD", "abc") + end},
        {"a late key colour", before + idat(stream) + pngChunk("tRNS", "abcdef") + end},
        {"texels in two places",
         before + idat(stream.substr(0, 99)) + pngChunk("tEXt", "t") + idat(stream.substr(99)) + end},
        {"no texels", before + idat("") + end},
    };
    for (const auto& [what, bytes] : files) {
        EXPECT_FALSE(isShort(bytes, picture)) << what;
        expectLikeLibpng(bytes, what);
    }
}

TEST(PngTexels, OfDamagedFilesAreThoseOfLibpng)
{
    Random random(5);
    int read = 0;
    for (int round = 0; round < 3000; ++round) {
        const Layout layout = kShort[random.below(std::size(kShort))];
        const Picture picture = {layout, 1 + static_cast<std::uint32_t>(random.below(9)),
                                 1 + static_cast<std::uint32_t>(random.below(9))};
        std::string file = picture.file(random);
        for (std::size_t i = 0; i <= random.below(3); ++i)
            file[8 + random.below(file.size() - 8)] = static_cast<char>(random.below(256));
        if (random.below(4) == 0)
            file.resize(8 + random.below(file.size() - 8));
        const test::LibpngResult expected = test::readByLibpng(file);
        const bool withinLimits = expected.image.width < 16384 && expected.image.height < 16384;
        if (withinLimits)
            expectLikeLibpng(file, "round " + std::to_string(round));
        read += expected.read;
    }
    EXPECT_GT(read, 0) << "some damage is none, such as the same value again";
}

// Damage that the CRCs do not show reaches the inflater and the filters.
TEST(PngTexels, OfDamagedStreamsAreThoseOfLibpng)
{
    Random random(6);
    for (int round = 0; round < 3000; ++round) {
        const Layout layout = kShort[random.below(std::size(kShort))];
        const Picture picture = {layout, 1 + static_cast<std::uint32_t>(random.below(20)),
                                 1 + static_cast<std::uint32_t>(random.below(9))};
        const std::string before = picture.before(random);
        std::string stream = picture.stream(random);
        for (std::size_t i = 0; i <= random.below(3); ++i)
            stream[random.below(stream.size())] = static_cast<char>(random.below(256));
        if (random.below(4) == 0)
            stream.resize(random.below(stream.size()));
        expectLikeLibpng(before + pngChunk("IDAT", stream) + pngChunk("IEND", ""), "round " + std::to_string(round));
    }
}

TEST(PngTexels, DoNotDependOnWhatTheMemoryHeldBefore)
{
    Random random(7);
    DecodeScratch scratch;
    for (int round = 0; round < 60; ++round) {
        const Layout layout = kShort[random.below(std::size(kShort))];
        const Picture picture = {layout, 1 + static_cast<std::uint32_t>(random.below(40)),
                                 1 + static_cast<std::uint32_t>(random.below(40))};
        const std::string file = picture.file(random);
        const TextureImage image = decodeTexture(std::as_bytes(std::span(file)), "", "", scratch);
        EXPECT_TRUE(image.texels == decode(file).image.texels);
    }
}

} // namespace
} // namespace torrance
