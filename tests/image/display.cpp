// What a window shows against what a file holds of the same picture.
#include "drawing.h"
#include "gpu/test_device.h"

#include "image/quantize.h"
#include "passes/display_pass.h"
#include "passes/targets.h"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

namespace torrance {
namespace {

constexpr int kWidth = 64, kHeight = 48;
constexpr vk::Format kCodes = vk::Format::eR8G8B8A8Unorm;

// Radiances over 12 decades, grey and coloured, and black; below, coverage falls to 0.
Image testPicture()
{
    Image picture(kWidth, kHeight, 4);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float value = x == 0 ? 0.0f : std::pow(10.0f, -6.0f + 12.0f * float(x) / float(kWidth));
            const float coverage = y < 32 ? 1.0f : float(kHeight - 1 - y) / 16.0f;
            float* texel = picture.at(x, y);
            texel[0] = coverage * value;
            texel[1] = coverage * value * float(y % 8) / 7.0f;
            texel[2] = coverage * value * float(y / 8 % 4) / 3.0f;
            texel[3] = coverage;
        }
    return picture;
}

gpu::DeviceImage onDevice(const Image& picture)
{
    const gpu::Device& device = test::device();
    gpu::DeviceImage image = makeColorTarget(device, picture.width, picture.height, "shown");
    const gpu::Buffer texels = gpu::makeBuffer(device, std::as_bytes(std::span(picture.texels)),
                                               vk::BufferUsageFlagBits::eTransferSrc, "texels");
    gpu::Commands commands(device);
    gpu::copyToImage(commands, texels, image, 4 * sizeof(float));
    commands.submitAndWait();
    return image;
}

CodeImage shown(const Image& picture, const DisplaySettings& settings, const DisplayPlace& place)
{
    const gpu::Device& device = test::device();
    const gpu::DeviceImage source = onDevice(picture);
    const gpu::DeviceImage target = makeCodeTarget(device, kCodes, kWidth, kHeight, "window");
    DisplayPass pass(device, test::shaders(), kCodes);
    gpu::Commands commands(device);
    commands.use({gpu::use(source, gpu::Access::sampled)});
    const gpu::DeviceImage* const targets[] = {&target};
    beginRendering(commands, targets, nullptr, kClearToNothing, LoadTarget::clear);
    const gpu::Buffer block = pass.draw(commands, source, place, settings);
    commands.buffer.endRendering();
    commands.submitAndWait();
    return readCodes(device, target);
}

DisplayPlace wholePicture()
{
    return {.size = {kWidth, kHeight}};
}

TEST(Display, CodesLieWithinOneOfAFiles)
{
    const Image picture = testPicture();
    for (const ToneCurve& tone : allToneCurves())
        for (const TransferCurve& transfer : allTransferCurves())
            for (const double exposure : {0.0, -1.5, 2.0}) {
                const DisplaySettings settings = {.exposure = exposure, .tone = &tone, .transfer = &transfer};
                const CodeImage window = shown(picture, settings, wholePicture());
                const Image file = toDisplay(picture, settings);
                int worst = 0, different = 0;
                for (int y = 0; y < 32; ++y) // where all is covered
                    for (int x = 0; x < kWidth; ++x)
                        for (int c = 0; c < 3; ++c) {
                            const int code = quantized(file.at(x, y)[c], 255);
                            const int difference = std::abs(window.at(x, y)[c] - code);
                            worst = std::max(worst, difference);
                            different += difference != 0;
                        }
                EXPECT_LE(worst, 1) << tone.id << " " << transfer.id << " " << exposure;
                EXPECT_LE(different, 32 * kWidth * 3 / 100) << tone.id << " " << transfer.id << " " << exposure;
            }
}

TEST(Display, UncoveredPixelsShowSquares)
{
    const CodeImage window = shown(testPicture(), {}, wholePicture());
    const int dark = 89, light = 115; // round(255 * 0.35), round(255 * 0.45)
    const int last = kHeight - 1;     // covered by nothing, in the sixth row of squares
    for (int x = 0; x < kWidth; ++x)
        EXPECT_NEAR(window.at(x, last)[1], (x / 8 + last / 8) % 2 == 0 ? dark : light, 1) << x;
}

TEST(Display, APictureAppearsWhereItIsPut)
{
    Image white(kWidth, kHeight, 4, 1.0f);
    const CodeImage window = shown(white, {.tone = findToneCurve("none")}, {.origin = {10, 7}, .size = {20, 30}});
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const bool inside = x >= 10 && x < 30 && y >= 7 && y < 37;
            ASSERT_EQ(window.at(x, y)[0], inside ? 255 : 0) << x << " " << y;
        }
}

TEST(Display, ColumnsCanBeLeftOut)
{
    const Image white(kWidth, kHeight, 4, 1.0f);
    const CodeImage window = shown(white, {.tone = findToneCurve("none")}, {.size = {kWidth, kHeight}, .skip = 20});
    EXPECT_EQ(window.at(19, 5)[0], 0);
    EXPECT_EQ(window.at(20, 5)[0], 255);
}

TEST(Display, NumbersAreScaledAndMoved)
{
    const Image picture(kWidth, kHeight, 4, 1.0f);
    const CodeImage window = shown(picture, {.tone = findToneCurve("none"), .transfer = findTransferCurve("linear")},
                                   {.size = {kWidth, kHeight}, .factor = 0.25, .offset = 0.5});
    EXPECT_NEAR(window.at(3, 3)[0], 191, 1); // 0.75 * 255
}

} // namespace
} // namespace torrance
