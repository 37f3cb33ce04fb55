#include "files/hdr_file.h"

#include "core/error.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

Image decode(const std::string& bytes)
{
    return decodeHdr(std::as_bytes(std::span(bytes)), "sky.hdr");
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

std::string file(const std::string& variables, const std::string& resolution, std::string_view texels)
{
    return "#?RADIANCE\n" + variables + "\n" + resolution + "\n" + std::string(texels);
}

using namespace std::string_literals;
using namespace std::string_view_literals;

// Mantissas 128, 64, 32 with exponent 129: 128 * 2^(129 - 136) = 1, a half, a quarter.
constexpr auto kTexel = "\x80\x40\x20\x81"sv;

TEST(HdrFile, DecodesMantissaAndExponent)
{
    const Image image = decode(file("FORMAT=32-bit_rle_rgbe\n", "-Y 1 +X 2", std::string(kTexel) + "\xff\xff\xff\0"s));
    EXPECT_EQ(image.texels, (std::vector<float>{1.0f, 0.5f, 0.25f, 0.0f, 0.0f, 0.0f})) << "exponent 0 is black";
}

TEST(HdrFile, DividesByExposureAndColourCorrection)
{
    // Both accumulate, and say what the stored values were multiplied with (Radiance file formats, "EXPOSURE").
    const Image image = decode(file("EXPOSURE=2\nEXPOSURE= 4.0\nCOLORCORR=1 2 4\n", "-Y 1 +X 1", kTexel));
    EXPECT_EQ(image.texels, (std::vector<float>{1.0f / 8, 0.5f / 16, 0.25f / 32}));
    EXPECT_NE(problemOf(file("EXPOSURE=0\n", "-Y 1 +X 1", kTexel)), "");
    EXPECT_NE(problemOf(file("EXPOSURE=nan\n", "-Y 1 +X 1", kTexel)), "");
}

// Texels of a 2x2 picture that are told apart by their red: 1, 2, 3, 4 in the order of the file.
constexpr auto kFour = "\x80\0\0\x81\x80\0\0\x82\xc0\0\0\x82\x80\0\0\x83"sv;

std::vector<float> redsOf(const std::string& resolution)
{
    const Image image = decode(file("", resolution, kFour));
    return {*image.at(0, 0), *image.at(1, 0), *image.at(0, 1), *image.at(1, 1)};
}

TEST(HdrFile, TurnsAllEightOrientationsUpright)
{
    // The first axis is that of the lines, its sign the direction in which they follow: -Y downwards, +X to the right.
    EXPECT_EQ(redsOf("-Y 2 +X 2"), (std::vector<float>{1, 2, 3, 4}));
    EXPECT_EQ(redsOf("-Y 2 -X 2"), (std::vector<float>{2, 1, 4, 3}));
    EXPECT_EQ(redsOf("+Y 2 +X 2"), (std::vector<float>{3, 4, 1, 2}));
    EXPECT_EQ(redsOf("+Y 2 -X 2"), (std::vector<float>{4, 3, 2, 1}));
    EXPECT_EQ(redsOf("+X 2 -Y 2"), (std::vector<float>{1, 3, 2, 4}));
    EXPECT_EQ(redsOf("-X 2 -Y 2"), (std::vector<float>{3, 1, 4, 2}));
    EXPECT_EQ(redsOf("+X 2 +Y 2"), (std::vector<float>{2, 4, 1, 3}));
    EXPECT_EQ(redsOf("-X 2 +Y 2"), (std::vector<float>{4, 2, 3, 1}));
}

TEST(HdrFile, ReadsOldRuns)
{
    // One texel, then a run of 2: three alike.
    EXPECT_EQ(decode(file("", "-Y 1 +X 3", std::string(kTexel) + "\1\1\1\2"s)).texels,
              (std::vector<float>{1, 0.5f, 0.25f, 1, 0.5f, 0.25f, 1, 0.5f, 0.25f}));
    // Two run texels in a row count for 1 + 256.
    EXPECT_EQ(decode(file("", "-Y 1 +X 258", std::string(kTexel) + "\1\1\1\1\1\1\1\1"s)).texels.back(), 0.25f);
}

TEST(HdrFile, ReadsNewRuns)
{
    // A line of 8: red is a run, green eight bytes, blue and exponent runs.
    const std::string line =
        "\2\2\0\x8"s + "\x88\x80"s + "\x8\0\x10\x20\x30\x40\x50\x60\x70"s + "\x88\0"s + "\x88\x81"s;
    const Image image = decode(file("", "-Y 1 +X 8", line));
    for (int x = 0; x < 8; ++x) {
        EXPECT_EQ(image.at(x, 0)[0], 1.0f);
        EXPECT_EQ(image.at(x, 0)[1], static_cast<float>(x) / 8.0f);
        EXPECT_EQ(image.at(x, 0)[2], 0.0f);
    }
}

TEST(HdrFile, RefusesWhatIsDamaged)
{
    EXPECT_NE(problemOf("#?RADIANCE\nno end").find("header has no end"), std::string::npos);
    EXPECT_NE(problemOf(file("FORMAT=32-bit_rle_xyze\n", "-Y 1 +X 1", kTexel)).find("xyze"), std::string::npos);
    EXPECT_NE(problemOf(file("", "-Y 1 -Y 1", kTexel)), "");
    EXPECT_NE(problemOf(file("", "-Y 0 +X 1", "")), "");
    EXPECT_NE(problemOf(file("", "-Y -1 +X 1", "")), "");
    EXPECT_NE(problemOf(file("", "-Y 100000 +X 100000", kTexel)).find("32768"), std::string::npos);
    EXPECT_NE(problemOf(file("", "-Y 99999999999 +X 1", kTexel)), "");
    EXPECT_NE(problemOf(file("", "-Y 1 +X 2", "\1\1\1\2")), "") << "a run of nothing";
    EXPECT_NE(problemOf(file("", "-Y 1 +X 2", std::string(kTexel) + "\1\1\1\2"s)), "") << "a run past the line";
    std::string endless(kTexel);
    for (int i = 0; i < 100; ++i)
        endless += "\1\1\1\0"s;
    EXPECT_NE(problemOf(file("", "-Y 1 +X 2", endless)), "");
    EXPECT_NE(problemOf(file("", "-Y 1 +X 9", "\2\2\0\x8"s + std::string(40, '\x88'))), "") << "another length";
    EXPECT_NE(problemOf(file("", "-Y 1 +X 8", "\2\2\0\x8"s + std::string(40, '\xff'))), "") << "a run past the line";
    EXPECT_NE(problemOf(file("", "-Y 1 +X 8", "\2\2\0\x8"s + std::string(40, '\0'))), "") << "a run of no length";
}

Image ramp(int width, int height)
{
    Image image(width, height, 3);
    for (std::size_t i = 0; i < image.texels.size(); ++i)
        image.texels[i] = std::exp2(static_cast<float>(i % 61) - 30.0f) * (1.0f + 0.01f * static_cast<float>(i % 7));
    return image;
}

std::string encoded(const Image& image)
{
    const std::vector<std::byte> bytes = encodeHdr(image);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(HdrFile, RefusesEveryTruncation)
{
    const std::string whole = encoded(ramp(9, 3));
    for (std::size_t length = 1; length < whole.size(); ++length)
        EXPECT_NE(problemOf(whole.substr(0, length)), "") << "cut to " << length << " bytes";
}

TEST(HdrFile, WritesWithinHalfAStepOfTheMantissa)
{
    for (const int width : {1, 7, 8, 300, 40000}) {
        const Image image = ramp(std::min(width, 32768), 2);
        const Image back = decode(encoded(image));
        for (std::size_t texel = 0; texel < image.texels.size(); texel += 3) {
            const float* in = &image.texels[texel];
            const float largest = std::max({in[0], in[1], in[2]});
            for (std::size_t channel = 0; channel < 3; ++channel)
                EXPECT_LE(std::abs(back.texels[texel + channel] - in[channel]), largest / 256.0f)
                    << width << " " << texel;
        }
    }
}

TEST(HdrFile, WritesRunsOfConstantLines)
{
    const Image image(1024, 1, 3, 0.5f);
    EXPECT_LT(encoded(image).size(), 200u) << "four channels of nine runs";
    EXPECT_EQ(decode(encoded(image)).texels, image.texels);
}

TEST(HdrFile, WritesNumbersForWhatIsNone)
{
    const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    for (const float value : {infinity, nan, -1.0f, 3.4e38f, 1e-45f})
        for (const float back : decode(encoded(Image(1, 1, 3, value))).texels)
            EXPECT_TRUE(std::isfinite(back) && back >= 0.0f) << value;
    EXPECT_EQ(decode(encoded(Image(1, 1, 3, 0.99999994f))).texels[0], 1.0f) << "rounds up into the next exponent";
}

} // namespace
} // namespace torrance
