// What is written is read back by the decoders, which have tests of their own against hand-laid files.
#include "files/image_write.h"

#include "core/error.h"
#include "files/image_read.h"
#include "image/srgb.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace torrance {
namespace {

namespace fs = std::filesystem;

class ImageWrite : public ::testing::Test
{
protected:
    ImageWrite()
    {
        std::string name = (fs::temp_directory_path() / "torrance-image-XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~ImageWrite() override { fs::remove_all(folder); }

    ReadImage through(const std::string& name, const Image& image, const WriteSettings& settings = {},
                      const std::vector<ImageLayer>& layers = {})
    {
        const std::string path = (folder / name).string();
        writePicture(path, image, layers, settings);
        return readImage(path);
    }

    fs::path folder;
};

// Smooth in space and covering [0, 1]; alpha, where there is one, a vertical ramp that multiplies the colour.
Image gradient(int width, int height, int channels)
{
    Image image(width, height, channels);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float alpha = channels == 4 ? static_cast<float>(y) / static_cast<float>(height - 1) : 1.0f;
            float* texel = image.at(x, y);
            texel[0] = alpha * static_cast<float>(x) / static_cast<float>(width - 1);
            texel[1] = alpha * 0.5f;
            texel[2] = alpha * (1.0f - static_cast<float>(y) / static_cast<float>(height));
            if (channels == 4)
                texel[3] = alpha;
        }
    return image;
}

const WriteSettings kPlain = {.tone = findToneCurve("none")};

// The largest distance of the codes from the sRGB-encoded, straight colour.
double worstCode(const ReadImage& picture, const Image& drawn)
{
    double worst = 0.0;
    for (int y = 0; y < drawn.height; ++y)
        for (int x = 0; x < drawn.width; ++x) {
            const float* in = drawn.at(x, y);
            const double alpha = drawn.channels == 4 ? in[3] : 1.0;
            for (int channel = 0; alpha > 0.0 && channel < 3; ++channel)
                worst = std::max(worst, std::abs(picture.image.at(x, y)[channel] -
                                                 srgbEncode(static_cast<double>(in[channel]) / alpha)));
            worst = std::max(worst, std::abs(picture.image.at(x, y)[3] - alpha));
        }
    return worst;
}

TEST_F(ImageWrite, PngIsWithinHalfACode)
{
    const Image image = gradient(37, 21, 4);
    EXPECT_LE(worstCode(through("a.png", image, kPlain), image), 0.5 / 255 + 1e-6);
    WriteSettings deep = kPlain;
    deep.bitsPerChannel = 16;
    EXPECT_LE(worstCode(through("b.png", image, deep), image), 0.5 / 65535 + 1e-6);
    EXPECT_LE(worstCode(through("c.PNG", gradient(5, 4, 3), kPlain), gradient(5, 4, 3)), 0.5 / 255 + 1e-6);
}

TEST_F(ImageWrite, WebpIsLosslessAtFullQualityAndNearBelow)
{
    WriteSettings settings = kPlain;
    settings.quality = 100;
    const Image image = gradient(37, 21, 4);
    EXPECT_LE(worstCode(through("a.webp", image, settings), image), 0.5 / 255 + 1e-6);
    // Lossy WebP stores BT.601 video range: luma steps of 255/219 codes, chroma steps that weigh up to 2.02, each
    // rounded by half and quantised once more by the flat block's only coefficient: below 5 codes on a flat picture.
    const Image flat(37, 21, 3, 0.3f);
    EXPECT_LE(worstCode(through("b.webp", flat, kPlain), flat), 5.0 / 255);
}

TEST_F(ImageWrite, JpegIsNearAndOverBlack)
{
    // Quality 100 divides by 1: what is left is the rounding of the transform and of YCbCr, two or three codes.
    WriteSettings settings = kPlain;
    settings.quality = 100;
    const ReadImage opaque = through("a.jpg", gradient(32, 32, 3), settings);
    EXPECT_LE(worstCode(opaque, gradient(32, 32, 3)), 3.5 / 255);
    const ReadImage covered = through("b.jpeg", gradient(32, 32, 4), settings);
    EXPECT_NEAR(covered.image.at(16, 0)[1], 0.0, 3.5 / 255) << "coverage 0";
    EXPECT_EQ(covered.image.at(16, 0)[3], 1.0f);
}

TEST_F(ImageWrite, ExrKeepsEveryBitAndName)
{
    Image beauty = gradient(9, 5, 4);
    beauty.texels[0] = 1e30f;
    beauty.texels[1] = -1.5f;
    ImageLayer depth = {.name = "depth", .channels = {"Z"}, .image = Image(9, 5, 1, 3.25f)};
    ImageLayer normal = {.name = "normal", .channels = {"X", "Y", "Z"}, .image = gradient(9, 5, 3)};
    const ReadImage back = through("a.exr", beauty, {.attributes = {{"torrance:plan", "none"}}}, {depth, normal});
    EXPECT_FALSE(back.displayReferred);
    EXPECT_EQ(back.channelNames,
              (std::vector<std::string>{"R", "G", "B", "A", "depth.Z", "normal.X", "normal.Y", "normal.Z"}));
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 9; ++x) {
            const float* texel = back.image.at(x, y);
            for (int channel = 0; channel < 4; ++channel)
                EXPECT_EQ(texel[channel], beauty.at(x, y)[channel]);
            EXPECT_EQ(texel[4], 3.25f);
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_EQ(texel[5 + channel], normal.image.at(x, y)[channel]);
        }
    std::ifstream file(folder / "a.exr", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(bytes.find("torrance:plan"), std::string::npos);
}

TEST_F(ImageWrite, HdrDropsAlphaAndKeepsLight)
{
    const ReadImage back = through("a.hdr", Image(16, 2, 4, 0.5f));
    EXPECT_EQ(back.channelNames, (std::vector<std::string>{"R", "G", "B"}));
    EXPECT_EQ(back.image.texels, std::vector<float>(16 * 2 * 3, 0.5f)) << "premultiplied colour, as it stands";
}

TEST_F(ImageWrite, GivesTheSameBytesTwice)
{
    const Image image = gradient(64, 40, 4);
    for (const ImageFormat format :
         {ImageFormat::png, ImageFormat::jpeg, ImageFormat::webp, ImageFormat::exr, ImageFormat::hdr})
        EXPECT_EQ(encodePicture(format, image, {}, {}), encodePicture(format, image, {}, {}));
}

TEST_F(ImageWrite, RefusesWhatTheFormatCannotHold)
{
    const auto codeOf = [&](const std::string& name, const WriteSettings& settings,
                            const std::vector<ImageLayer>& layers) {
        try {
            through(name, gradient(2, 2, 3), settings, layers);
        } catch (const Error& error) {
            return error.exitCode;
        }
        return ExitCode::success;
    };
    EXPECT_EQ(codeOf("a.jpg", {.bitsPerChannel = 16}, {}), ExitCode::usage);
    EXPECT_EQ(codeOf("a.png", {}, {{.name = "depth", .channels = {"Z"}, .image = Image(2, 2, 1)}}), ExitCode::usage);
    EXPECT_EQ(codeOf("a.tga", {}, {}), ExitCode::usage);
    EXPECT_EQ(codeOf("missing/a.png", {}, {}), ExitCode::cannotWrite);
    EXPECT_TRUE(fs::is_empty(folder)) << "nothing is left behind";
}

TEST_F(ImageWrite, NamesTheKnownFormats)
{
    try {
        imageFormatOf("a.pngg");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean .png?"), std::string::npos) << error.what();
    }
    EXPECT_EQ(imageFormatOf("-"), ImageFormat::png);
    EXPECT_EQ(imageFormatOf("x.JPEG"), ImageFormat::jpeg);
}

TEST_F(ImageWrite, RefusesTruncatedExr)
{
    const std::vector<std::byte> whole = encodePicture(ImageFormat::exr, gradient(33, 40, 3), {}, {});
    for (std::size_t length = 5; length < whole.size(); length += 7)
        EXPECT_THROW(decodeExr(std::span(whole).first(length), "a.exr"), Error) << "cut to " << length << " bytes";
}

TEST_F(ImageWrite, RefusesTruncatedJpegAndWebp)
{
    for (const ImageFormat format : {ImageFormat::jpeg, ImageFormat::webp}) {
        const std::vector<std::byte> whole = encodePicture(format, gradient(40, 40, 3), {}, {});
        const std::string path = (folder / "cut").string();
        for (std::size_t length = 1; length + 2 < whole.size(); length += 11) {
            std::ofstream(path, std::ios::binary)
                .write(reinterpret_cast<const char*>(whole.data()), static_cast<std::streamsize>(length));
            EXPECT_THROW(readImage(path), Error) << "cut to " << length << " bytes";
        }
    }
}

} // namespace
} // namespace torrance
