// Slot texture_filter: every pixel of a tilted square is what the texture's levels hold there, by every filter.
#include "drawing.h"
#include "plan/path_plan.h"
#include "reference/pixel_estimate.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "study/certificate.h"
#include "study/filter_ladder.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <random>
#include <stdexcept>

namespace torrance::test {
namespace {

using brdf::Slot;

constexpr int kSize = 64;

/// How far a sampler's own level may be off: where log2 m of a mantissa is taken for m - 1, by 0.0861 at m = 1 / ln 2,
/// and half of that of a squared step. What is drawn lies between levels that far to both sides.
constexpr double kLevelSlack = 0.0431;

/// Of what an exact level is off by: a texel is a half float (2^-12 of it), and interpolated coordinates keep some 20
/// bits (2^-20 of the square, 2^-12 texels of level 0, of which one differs from the next by 1 at most).
constexpr double kRounding = 0x1p-11;

// Whose levels are all different: what is read tells which level it was.
TextureImage noise(int side)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(0.0, 1.0);
    return makeTexels(side, side, TexelFormat::rgba8,
                      [&](int, int) { return dvec4(value(random), value(random), value(random), 1.0); });
}

Scene tiltedSquare(MipFilter mip)
{
    Scene scene;
    Material material = plainMaterial(dvec3(1.0), 0.0, 1.0);
    material.unlit = true;
    material.baseColor.texture = addTexture(scene, noise(256),
                                            {.wrapS = Wrap::repeat,
                                             .wrapT = Wrap::repeat,
                                             .magnify = Filter::linear,
                                             .minify = Filter::linear,
                                             .mip = mip});
    scene.materials.push_back(material);
    addInstance(scene, square(0), dmat4(1.0));
    return scene;
}

/// From so near the square's plane that its texels a pixel, and their change within a quad, are of all sizes.
Camera lowCamera()
{
    return orbitCamera({0.5, kPi / 2 - 1.25}, 2.6, dvec3(0.0), 0.7);
}

struct Filtered
{
    const char* method;
    MipFilter mip; // what the picture is drawn as
    double slack;  // of the level
};
constexpr Filtered kFilters[] = {{"trilinear", MipFilter::linear, kLevelSlack},
                                 {"trilinear_exact", MipFilter::linear, 0.0},
                                 {"trilinear_words", MipFilter::linear, kLevelSlack}, // one texture: as trilinear
                                 {"nearest_level", MipFilter::nearest, kLevelSlack}};

/// How far a drawn colour lies outside of what levels within the slack hold.
double excess(const std::vector<dvec4>& levels, const dvec4& drawn)
{
    double most = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (const dvec4& color : levels) {
            low = std::min(low, color[channel]);
            high = std::max(high, color[channel]);
        }
        most = std::max({most, low - drawn[channel], drawn[channel] - high});
    }
    return most;
}

TEST(TextureFilters, EveryFilterIsItsFormula)
{
    const Scene scene = tiltedSquare(MipFilter::linear);
    for (const Filtered& filter : kFilters)
        for (const auto& [path, samples] : {std::pair(RenderPath::forward, 1),
                                            {RenderPath::attributes, 1},
                                            {RenderPath::forward, 4},
                                            {RenderPath::attributes, 4}})
        {
            if (samples > 1 && filter.slack > 0.0)
                continue; // each sample has a level of its own, and no one of them bounds their mean
            Settings settings = settingsOf("gltf", kSize);
            settings.methods.textureFilter = brdf::findMethod(Slot::textureFilter, filter.method);
            settings.path = path;
            settings.samples = samples;
            const Picture picture = draw(scene, lowCamera(), settings);
            const Scene expected = tiltedSquare(filter.mip);
            std::vector<ReferenceSettings> exact;
            std::vector<std::unique_ptr<PixelEstimator>> estimators;
            constexpr int kSteps = 4; // between them a mean of two levels is linear, but where a level begins
            for (int i = -kSteps; i <= kSteps; ++i) {
                exact.push_back(exactSettings(settings, {}));
                *exact.back().levelBias += filter.slack * i / kSteps;
            }
            for (const ReferenceSettings& each : exact)
                estimators.push_back(std::make_unique<PixelEstimator>(expected, lowCamera(), each));
            double worst = 0.0;
            std::size_t compared = 0;
            for (int y = 0; y < kSize; ++y)
                for (int x = 0; x < kSize; ++x) {
                    if (estimators.front()->estimate(x, y, 0.0).covered < 1.0 || pixelOf(picture, x, y).a < 1.0)
                        continue; // part of the pixel sees no texture
                    std::vector<dvec4> colors;
                    for (const auto& estimator : estimators)
                        colors.push_back(estimator->estimate(x, y, 0.0).color);
                    worst = std::max(worst, excess(colors, pixelOf(picture, x, y)));
                    ++compared;
                }
            EXPECT_GT(compared, 800u);
            EXPECT_LE(worst, kRounding) << filter.method << ", path " << static_cast<int>(path) << ", " << samples;
        }
}

/// Sides that are no powers of two, read a few times over by a place of its own.
Scene tiltedMaterial(double repeats, dvec2 offset = dvec2(-0.7, 0.3))
{
    Scene scene;
    Material material = plainMaterial(dvec3(0.9, 0.8, 0.7), 0.9, 0.8);
    material.emissiveFactor = dvec3(0.4, 0.5, 0.6);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(0.0, 1.0);
    const auto texture = [&](double least, double greatest) {
        return addTexture(scene,
                          makeTexels(96, 80, TexelFormat::rgba8,
                                     [&](int, int) {
                                         const auto one = [&] { return least + (greatest - least) * value(random); };
                                         return dvec4(one(), one(), one(), 1.0);
                                     }),
                          {});
    };
    material.baseColor.texture = texture(0.0, 1.0);
    material.metallicRoughness.texture = texture(0.2, 1.0);
    material.normal.texture = texture(0.5, 0.8); // directions that do not cancel
    material.occlusion.texture = texture(0.0, 1.0);
    material.emissive.texture = texture(0.0, 1.0);
    for (TextureUse* use :
         {&material.baseColor, &material.metallicRoughness, &material.normal, &material.occlusion, &material.emissive})
        use->transform = glm::dmat3x2(repeats, 0.0, 0.0, -repeats, offset.x, offset.y);
    scene.materials.push_back(material);
    addInstance(scene, square(0), dmat4(1.0));
    scene.lights = {{.name = "lamp", .intensity = 3.0, .direction = glm::normalize(dvec3(0.3, 0.2, -1.0))}};
    return scene;
}

Settings filterSettings(const char* filter, RenderPath path, int samples = 1)
{
    Settings settings = settingsOf("gltf", kSize);
    settings.methods.textureFilter = brdf::findMethod(Slot::textureFilter, filter);
    settings.path = path;
    settings.samples = samples;
    return settings;
}

// A field is off by half a step, and so is every mean of fields. 4: a colour's square root may be off by 0.5 / 1023,
// its square by twice that; a normal is the double of its fields, and longer than 0.5 before it is made unit.
TEST(TextureFilters, WordsAreTheirTextures)
{
    for (const double repeats : {0.2, 1.5, 4.0, 150.0}) {
        const Scene scene = tiltedMaterial(repeats);
        Settings words = filterSettings("trilinear_words", RenderPath::forward);
        Settings apart = filterSettings("trilinear_exact", RenderPath::forward);
        words.layers = apart.layers = true;
        ASSERT_TRUE(makePlan(scene, words).batches[0].key.words.used);
        const Picture exact = draw(scene, lowCamera(), apart);
        for (const auto& drawing : {draw, drawForOneCamera}) {
            const Picture picture = drawing(scene, lowCamera(), words);
            for (std::size_t i = 0; i < exact.layers.size(); ++i) {
                const Image &own = picture.layers[i].image, &other = exact.layers[i].image;
                double worst = 0.0, greatest = 0.0;
                for (std::size_t k = 0; k < own.texels.size(); ++k) {
                    worst = std::max(worst, std::abs(double(own.texels[k]) - double(other.texels[k])));
                    greatest = std::max(greatest, std::abs(double(other.texels[k])));
                }
                EXPECT_LE(worst, 4.0 * 0.5 / 1023.0 * std::max(greatest, 1.0))
                    << exact.layers[i].name << ", read " << repeats << " times";
            }
        }
    }
}

TEST(TextureFilters, WordsAreReadAlikeOnAllPaths)
{
    for (const double repeats : {0.2, 4.0}) {
        const Scene scene = tiltedMaterial(repeats);
        for (const RenderPath path : kRenderPaths)
            for (const int samples : {1, 4}) {
                const Picture apart = draw(scene, lowCamera(), filterSettings("trilinear_exact", path, samples));
                const Picture words = draw(scene, lowCamera(), filterSettings("trilinear_words", path, samples));
                double difference = 0.0, light = 0.0;
                for (std::size_t i = 0; i < words.color.texels.size(); ++i) {
                    difference += std::abs(double(words.color.texels[i]) - double(apart.color.texels[i]));
                    light += std::abs(double(apart.color.texels[i]));
                }
                ASSERT_GT(light, 100.0);
                // Fields are off by 1/4 of a step on average, of roots of 0.5: 0.05 %; normals turn lights as little.
                EXPECT_LT(difference, 1e-3 * light)
                    << nameOf(path) << ", " << samples << " samples, read " << repeats << " times";
            }
    }
}

// Away from the sides what is mirrored there is read as what is repeated, and is not read as words. The device's own
// level is off by kLevelSlack at most to either side: there another one may be the nearer.
TEST(TextureFilters, WordsOfTheNearerLevelAreTheirTextures)
{
    Scene scene = tiltedMaterial(0.8, dvec2(0.1, 0.9));
    Scene apart = scene;
    for (Texture& texture : apart.textures)
        texture.sampler.wrapS = texture.sampler.wrapT = Wrap::mirroredRepeat;
    for (const RenderPath path : {RenderPath::forward, RenderPath::attributes}) {
        const Settings settings = filterSettings("nearest_level", path);
        ASSERT_TRUE(makePlan(scene, settings).batches[0].key.words.used);
        ASSERT_FALSE(makePlan(apart, settings).batches[0].key.words.used);
        const Picture words = draw(scene, lowCamera(), settings), other = draw(apart, lowCamera(), settings);
        int compared = 0, differing = 0;
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const dvec4 a = pixelOf(words, x, y), b = pixelOf(other, x, y);
                compared += b.a > 0.0;
                differing += glm::length(a - b) > 0.01 * glm::length(b);
            }
        EXPECT_GT(compared, 800);
        EXPECT_LT(differing, 2.0 * kLevelSlack * compared) << nameOf(path);
    }
}

TEST(TextureFilters, TexturesWithoutASecondLevelAreReadAlike)
{
    const Scene scene = tiltedSquare(MipFilter::none);
    Settings settings = settingsOf("gltf", kSize);
    const std::vector<float> texels = draw(scene, lowCamera(), settings).color.texels;
    for (const Filtered& filter : kFilters) {
        settings.methods.textureFilter = brdf::findMethod(Slot::textureFilter, filter.method);
        EXPECT_EQ(draw(scene, lowCamera(), settings).color.texels, texels) << filter.method;
    }
}

TEST(TextureFilters, LaddersKnowWhatFiltersChangeOfAPicture)
{
    Settings settings = settingsOf("gltf", kSize);
    settings.path = RenderPath::forward;
    std::vector<CoveredPixel> all;
    for (int i = 0; i < kSize * kSize; ++i)
        all.push_back({i % kSize, i / kSize});
    Scene scene = tiltedSquare(MipFilter::linear);
    Image last;
    const auto drawOf = [&](const Settings& own) -> const Image& { return last = draw(scene, lowCamera(), own).color; };
    const auto minified = filterLadder(scene, settings, all, drawOf);
    ASSERT_TRUE(minified);
    ASSERT_GE(minified->rungs.size(), 2u);
    EXPECT_EQ(minified->rungs.front().method->id, "nearest_level");
    EXPECT_EQ(minified->rungs.back().method->id, "trilinear_exact");
    EXPECT_EQ(minified->rungs.back().error, 0.0);
    // Half a level at most lies between what is read and what should be, a quarter on average: of noise of this kind a
    // level is half as loud as the one before, and a picture of its levels is off by several per cent of its light.
    EXPECT_GT(minified->rungs.front().error, 0.01);
    EXPECT_LT(minified->rungs.front().error, 0.25);

    scene.images.front() = noise(8); // magnified everywhere
    const auto magnified = filterLadder(scene, settings, all, drawOf);
    ASSERT_TRUE(magnified);
    EXPECT_EQ(magnified->rungs.size(), 1u) << "the cheapest draws the same";
    EXPECT_EQ(magnified->refused.size(), 3u);

    scene = tiltedSquare(MipFilter::none);
    const auto never = [](const Settings&) -> const Image& { throw std::logic_error("drawn for nothing"); };
    EXPECT_FALSE(filterLadder(scene, settings, all, never));
}

} // namespace
} // namespace torrance::test
