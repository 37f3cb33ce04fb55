// PNG decoding against files whose bytes the test lays out itself from the PNG specification.
#include "core/error.h"
#include "files/texture_file.h"
#include "png_bytes.h"

#include <cstring>
#include <gtest/gtest.h>

namespace torrance {
namespace {

using test::pngBytes;
using test::PngSpec;

TextureImage decode(const std::string& bytes)
{
    return decodeTexture(std::as_bytes(std::span(bytes)), "image 3", "scene.glb");
}

std::vector<int> codes8(const TextureImage& image)
{
    std::vector<int> codes;
    for (const std::byte value : image.texels)
        codes.push_back(std::to_integer<int>(value));
    return codes;
}

std::vector<int> codes16(const TextureImage& image)
{
    std::vector<std::uint16_t> native(image.texels.size() / 2);
    std::memcpy(native.data(), image.texels.data(), image.texels.size());
    return {native.begin(), native.end()};
}

std::string problemOf(const std::string& bytes)
{
    try {
        decode(bytes);
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::input);
        return error.what();
    }
    return "";
}

const PngSpec kTwoByTwo = {.width = 2,
                           .height = 2,
                           .scanlines = {0, 10, 20, 30, 40, 50, 60, 70, 80, 0, 90, 100, 110, 120, 130, 140, 150, 160}};

TEST(TexturePng, KeepsRgbaAsStored)
{
    const TextureImage image = decode(pngBytes(kTwoByTwo));
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(image.height, 2);
    EXPECT_EQ(image.format, TexelFormat::rgba8);
    EXPECT_EQ(image.name, "image 3");
    EXPECT_EQ(codes8(image), (std::vector{10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120, 130, 140, 150, 160}));
}

TEST(TexturePng, FillsMissingChannels)
{
    EXPECT_EQ(codes8(decode(pngBytes({.colorType = 2, .scanlines = {0, 1, 2, 3}}))), (std::vector{1, 2, 3, 255}));
    EXPECT_EQ(codes8(decode(pngBytes({.colorType = 0, .scanlines = {0, 7}}))), (std::vector{7, 7, 7, 255}));
    EXPECT_EQ(codes8(decode(pngBytes({.colorType = 4, .scanlines = {0, 7, 9}}))), (std::vector{7, 7, 7, 9}));
}

TEST(TexturePng, ScalesFewBitsToTheFullRange)
{
    // Sample depth scaling, PNG specification 13.12: v * 255 / (2^depth - 1). Two texels of 4 bits: 0x1 and 0xf.
    EXPECT_EQ(codes8(decode(pngBytes({.width = 2, .bitDepth = 4, .colorType = 0, .scanlines = {0, 0x1f}}))),
              (std::vector{17, 17, 17, 255, 255, 255, 255, 255}));
}

TEST(TexturePng, LooksUpPalettesAndTheirTransparency)
{
    // Entries (1,2,3) with alpha 128 and (4,5,6), whose alpha tRNS leaves out: opaque.
    const PngSpec spec = {.width = 2,
                          .colorType = 3,
                          .scanlines = {0, 0, 1},
                          .chunks = {{"PLTE", "\x01\x02\x03\x04\x05\x06"}, {"tRNS", "\x80"}}};
    EXPECT_EQ(codes8(decode(pngBytes(spec))), (std::vector{1, 2, 3, 128, 4, 5, 6, 255}));
}

TEST(TexturePng, MakesTheKeyColourTransparent)
{
    // tRNS of a grey image names one 16-bit grey value: 7.
    const PngSpec spec = {
        .width = 2, .colorType = 0, .scanlines = {0, 7, 8}, .chunks = {{"tRNS", std::string("\0\x07", 2)}}};
    EXPECT_EQ(codes8(decode(pngBytes(spec))), (std::vector{7, 7, 7, 0, 8, 8, 8, 255}));
}

TEST(TexturePng, KeepsSixteenBitsInNativeOrder)
{
    const PngSpec spec = {.bitDepth = 16, .colorType = 2, .scanlines = {0, 0x12, 0x34, 0x00, 0xff, 0xff, 0xfe}};
    const TextureImage image = decode(pngBytes(spec));
    EXPECT_EQ(image.format, TexelFormat::rgba16);
    EXPECT_EQ(codes16(image), (std::vector{0x1234, 0x00ff, 0xfffe, 0xffff}));
}

TEST(TexturePng, UnweavesAdam7)
{
    // 2x2 grey: pass 1 holds (0,0), pass 6 (1,0), pass 7 row 1 (PNG specification 8.2).
    const PngSpec spec = {
        .width = 2, .height = 2, .colorType = 0, .interlace = 1, .scanlines = {0, 11, 0, 22, 0, 33, 44}};
    const std::vector<int> codes = codes8(decode(pngBytes(spec)));
    EXPECT_EQ((std::vector{codes[0], codes[4], codes[8], codes[12]}), (std::vector{11, 22, 33, 44}));
}

TEST(TexturePng, IgnoresGammaAndProfiles)
{
    PngSpec spec = kTwoByTwo;
    const std::vector<int> plain = codes8(decode(pngBytes(spec)));
    spec.chunks = {{"gAMA", std::string("\0\x01\x86\xa0", 4)}, {"iCCP", "broken profile"}};
    EXPECT_EQ(codes8(decode(pngBytes(spec))), plain);
}

TEST(TexturePng, RefusesEveryTruncation)
{
    const std::string whole = pngBytes(kTwoByTwo);
    for (std::size_t length = 1; length < whole.size(); ++length)
        EXPECT_NE(problemOf(whole.substr(0, length)), "") << "cut to " << length << " bytes";
}

TEST(TexturePng, RefusesFlippedBits)
{
    // Every byte after the signature lies under a CRC; a flip may not pass unseen.
    const std::string whole = pngBytes(kTwoByTwo);
    for (std::size_t i = 8; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
        EXPECT_NE(problemOf(damaged), "") << "byte " << i;
    }
}

TEST(TexturePng, NamesFileImageAndRemedyInOneLine)
{
    const std::string problem = problemOf(pngBytes(kTwoByTwo).substr(0, 60));
    EXPECT_EQ(problem.rfind("scene.glb: image 3: ", 0), 0u) << problem;
    EXPECT_NE(problem.find("; "), std::string::npos) << problem;
    EXPECT_EQ(problem.find('\n'), std::string::npos) << problem;
}

TEST(TexturePng, RefusesSizesOfNoUse)
{
    EXPECT_NE(problemOf(pngBytes({.width = 0, .scanlines = {0}})), "");
    EXPECT_NE(problemOf(pngBytes({.width = 1000000, .scanlines = {0}})).find("16384"), std::string::npos);
    // Within the limits, but 1 GiB of texels out of a hundred bytes: refused before memory is taken.
    EXPECT_NE(problemOf(pngBytes({.width = 16384, .height = 16384, .scanlines = {0}})).find("too early"),
              std::string::npos);
}

TEST(TexturePng, TellsTheSizeFromTheHeader)
{
    const std::string bytes = pngBytes({.width = 640, .height = 480, .scanlines = {0}});
    const auto size = textureSize(std::as_bytes(std::span(bytes)));
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, 640);
    EXPECT_EQ(size->height, 480);
    EXPECT_FALSE(textureSize(std::as_bytes(std::span(bytes)).first(10)));
}

TEST(TextureFile, RefusesOtherKinds)
{
    EXPECT_NE(problemOf(""), "");
    EXPECT_NE(problemOf("GIF89a and so on").find("neither PNG"), std::string::npos);
}

} // namespace
} // namespace torrance
