// JPEG and WebP decoding. Files come from the libraries' own encoders, called here and not through the program's
// writers.
#include "core/error.h"
#include "core/log.h"
#include "files/texture_file.h"

#include <gtest/gtest.h>
#include <turbojpeg.h>
#include <webp/encode.h>

namespace torrance {
namespace {

using Bytes = std::vector<std::byte>;

Bytes bytesOf(const unsigned char* data, std::size_t size)
{
    const auto* from = reinterpret_cast<const std::byte*>(data);
    return {from, from + size};
}

// 16 x 16 of one colour, quality 100.
Bytes flatJpeg(TJPF layout, TJSAMP sampling, std::vector<unsigned char> texel, int flags = 0)
{
    std::vector<unsigned char> pixels;
    for (int i = 0; i < 16 * 16; ++i)
        pixels.insert(pixels.end(), texel.begin(), texel.end());
    const tjhandle encoder = tjInitCompress();
    unsigned char* data = nullptr;
    unsigned long size = 0;
    EXPECT_EQ(tjCompress2(encoder, pixels.data(), 16, 0, 16, layout, &data, &size, sampling, 100, flags), 0);
    const Bytes bytes = bytesOf(data, size);
    tjFree(data);
    tjDestroy(encoder);
    return bytes;
}

std::vector<int> firstTexel(const TextureImage& image)
{
    return {std::to_integer<int>(image.texels[0]), std::to_integer<int>(image.texels[1]),
            std::to_integer<int>(image.texels[2]), std::to_integer<int>(image.texels[3])};
}

std::string problemOf(const Bytes& bytes)
{
    try {
        decodeTexture(bytes, "image 0", "a.glb");
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::input);
        return error.what();
    }
    return "";
}

// A segment right after the start of the file: marker, length, content.
Bytes withSegment(const Bytes& jpeg, int marker, const std::string& content)
{
    Bytes result(jpeg.begin(), jpeg.begin() + 2);
    const std::size_t length = content.size() + 2;
    for (const std::size_t value : {std::size_t(0xff), static_cast<std::size_t>(marker), length >> 8, length & 0xff})
        result.push_back(static_cast<std::byte>(value));
    for (const char c : content)
        result.push_back(static_cast<std::byte>(c));
    result.insert(result.end(), jpeg.begin() + 2, jpeg.end());
    return result;
}

TEST(TextureJpeg, DecodesColourAndGreyToRgba)
{
    // A flat block at quality 100 has one coefficient, quantised by 1: what is left is the rounding to YCbCr, a code or
    // two.
    const TextureImage color = decodeTexture(flatJpeg(TJPF_RGB, TJSAMP_444, {200, 100, 50}), "image 0", "a.glb");
    EXPECT_EQ(color.width, 16);
    EXPECT_EQ(color.format, TexelFormat::rgba8);
    const std::vector<int> texel = firstTexel(color);
    EXPECT_NEAR(texel[0], 200, 2);
    EXPECT_NEAR(texel[1], 100, 2);
    EXPECT_NEAR(texel[2], 50, 2);
    EXPECT_EQ(texel[3], 255);
    const TextureImage grey = decodeTexture(flatJpeg(TJPF_GRAY, TJSAMP_GRAY, {77}), "image 0", "a.glb");
    EXPECT_EQ(firstTexel(grey), (std::vector{77, 77, 77, 255}));
}

TEST(TextureJpeg, DecodesProgressiveFiles)
{
    const Bytes bytes = flatJpeg(TJPF_GRAY, TJSAMP_GRAY, {77}, TJFLAG_PROGRESSIVE);
    EXPECT_EQ(firstTexel(decodeTexture(bytes, "image 0", "a.glb")), (std::vector{77, 77, 77, 255}));
}

TEST(TextureJpeg, IgnoresProfiles)
{
    const Bytes plain = flatJpeg(TJPF_RGB, TJSAMP_444, {200, 100, 50});
    const Bytes profiled = withSegment(plain, 0xe2, std::string("ICC_PROFILE\0\1\1 not a profile at all", 35));
    EXPECT_EQ(decodeTexture(profiled, "", "a.glb").texels, decodeTexture(plain, "", "a.glb").texels);
}

TEST(TextureJpeg, RefusesCmykByName)
{
    EXPECT_NE(problemOf(flatJpeg(TJPF_CMYK, TJSAMP_444, {10, 20, 30, 40})).find("CMYK"), std::string::npos);
}

TEST(TextureJpeg, RefusesDamage)
{
    const Bytes whole = flatJpeg(TJPF_RGB, TJSAMP_444, {200, 100, 50});
    for (std::size_t length = 3; length + 2 < whole.size(); ++length) {
        const std::string problem =
            problemOf(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)));
        EXPECT_EQ(problem.rfind("a.glb: image 0: ", 0), 0u) << "cut to " << length << ": " << problem;
    }
}

TEST(TextureJpeg, ToleratesStrayBytesBetweenSegments)
{
    // Some encoders leave a byte or two before the end marker; no texel depends on them.
    const Bytes plain = flatJpeg(TJPF_RGB, TJSAMP_444, {200, 100, 50});
    Bytes stray = plain;
    stray.insert(stray.end() - 2, {std::byte(0x12), std::byte(0x34)});
    const LogLevel level = logLevel();
    setLogLevel(LogLevel::quiet);
    EXPECT_EQ(decodeTexture(stray, "", "a.glb").texels, decodeTexture(plain, "", "a.glb").texels);
    setLogLevel(level);
}

TEST(TextureJpeg, TellsTheSize)
{
    const auto size = textureSize(flatJpeg(TJPF_RGB, TJSAMP_420, {1, 2, 3}));
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, 16);
    EXPECT_EQ(size->height, 16);
}

Bytes losslessWebp(std::vector<std::uint8_t> pixels, int width, int height)
{
    std::uint8_t* data = nullptr;
    const std::size_t size = WebPEncodeLosslessRGBA(pixels.data(), width, height, 4 * width, &data);
    const Bytes bytes = bytesOf(data, size);
    WebPFree(data);
    return bytes;
}

TEST(TextureWebp, KeepsStraightAlpha)
{
    const Bytes bytes = losslessWebp({200, 100, 50, 255, 90, 80, 70, 128}, 2, 1);
    const TextureImage image = decodeTexture(bytes, "image 0", "a.glb");
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(firstTexel(image), (std::vector{200, 100, 50, 255}));
    EXPECT_EQ(std::to_integer<int>(image.texels[4]), 90) << "not multiplied by its alpha";
    EXPECT_EQ(textureSize(bytes)->width, 2);
}

TEST(TextureWebp, RefusesDamage)
{
    const Bytes whole = losslessWebp(std::vector<std::uint8_t>(32 * 32 * 4, 77), 32, 32);
    for (std::size_t length = 12; length + 1 < whole.size(); ++length)
        EXPECT_NE(problemOf(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length))), "") << length;
}

} // namespace
} // namespace torrance
