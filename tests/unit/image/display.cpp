#include "image/display.h"

#include "image/srgb.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

Image pixel(std::vector<float> channels)
{
    Image image(1, 1, static_cast<int>(channels.size()));
    image.texels = std::move(channels);
    return image;
}

TEST(Display, ExposesThenCurvesThenEncodes)
{
    // Reinhard by hand: 0.25 at +2 stops is 1, whose curve is 1/2.
    const Image shown = toDisplay(pixel({0.25f, 0.25f, 0.25f}), {.exposure = 2.0, .tone = findToneCurve("reinhard")});
    EXPECT_NEAR(shown.texels[0], srgbEncode(0.5), 1e-6);
}

TEST(Display, DividesByCoverageBeforeTheCurve)
{
    // A half-covered pixel of the surface colour 0.8 shows that surface, half transparent.
    const DisplaySettings settings = {.tone = findToneCurve("khronos_neutral")};
    const Image whole = toDisplay(pixel({0.8f, 0.4f, 0.2f, 1.0f}), settings);
    const Image half = toDisplay(pixel({0.4f, 0.2f, 0.1f, 0.5f}), settings);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_FLOAT_EQ(half.texels[i], whole.texels[i]);
    EXPECT_EQ(half.texels[3], 0.5f);
}

TEST(Display, CompositesOverBlackWhereThereIsNoAlpha)
{
    const Image shown =
        toDisplay(pixel({0.4f, 0.2f, 0.1f, 0.5f}), {.tone = findToneCurve("none"), .alpha = AlphaRule::overBlack});
    ASSERT_EQ(shown.channels, 3);
    EXPECT_NEAR(shown.texels[0], srgbEncode(0.4), 1e-6);
}

TEST(Display, GivesNumbersForWhatIsNone)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (const ToneCurve& tone : allToneCurves())
        for (const float alpha : {0.0f, 1e-45f, 0.5f, 1.0f, 2.0f, nan, infinity, -1.0f})
            for (const float value : {nan, infinity, -infinity, -1.0f, 65504.0f, 3e38f})
                for (const float shown : toDisplay(pixel({value, 0.5f, value, alpha}), {.tone = &tone}).texels)
                    EXPECT_TRUE(std::isfinite(shown)) << tone.id << " of " << value << " under alpha " << alpha;
}

TEST(Display, UncoveredIsTransparentBlack)
{
    const Image shown = toDisplay(pixel({0.0f, 0.0f, 0.0f, 0.0f}), {});
    EXPECT_EQ(shown.texels, std::vector<float>({0.0f, 0.0f, 0.0f, 0.0f}));
}

} // namespace
} // namespace torrance
