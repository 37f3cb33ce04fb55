// Certificates held against what they speak of: the error of every pixel.
#include "study/certificate.h"
#include "certified_scenes.h"
#include "drawing.h"
#include "reference/pixel_estimate.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "study/pixel_sample.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr int kSeeds = 10;
constexpr std::uint64_t kTruthSeed = 1u << 20; // of no certificate
constexpr CertificateRequest kSmall = {.pixels = 48, .directions = 256};

Certificate certifyWith(const CertifiedScene& s, const Image& drawn, std::uint64_t seed)
{
    CertificateRequest request = kSmall;
    request.seed = seed;
    return certify(s.scene, s.camera, s.settings, drawn, request);
}

/// Of all covered pixels, from many more directions than a certificate takes, and others.
Certificate truthOf(const CertifiedScene& s, const Image& drawn)
{
    return certify(s.scene, s.camera, s.settings, drawn,
                   {.pixels = kMostCertified, .seed = kTruthSeed, .directions = 2048});
}

std::string percent(double share)
{
    return std::isfinite(share) ? fmt::format("{:.3g} %", 100.0 * share) : "–";
}

/// A line of the table in docs/certificate.md, which tools/certificate_page.sh puts there.
std::string tableLine(int number, const CertifiedScene& s, const Certificate& truth, const Certificate& stated,
                      int held)
{
    const Bounded& mean = stated.shading.mean;
    return fmt::format("| {} | {} | {} | {} | {} | {} to {} | {} of {} |\n", number, s.name, truth.covered,
                       percent(truth.shading.mean.value), percent(mean.value), percent(mean.low), percent(mean.high),
                       held, kSeeds);
}

TEST(Certificate, IntervalsHoldTheMeanErrorOfAllPixelsAsOftenAsTheySay)
{
    const std::filesystem::path folder = std::filesystem::path(TORRANCE_BINARY_DIR) / "tests";
    std::ofstream table(folder / "certificates.md");
    int held = 0;
    for (int i = 0; i < kCertifiedScenes; ++i) {
        const CertifiedScene s = certifiedScene(i);
        const Image drawn = draw(s.scene, s.camera, s.settings).color;
        const Certificate truth = truthOf(s, drawn);
        ASSERT_GT(truth.covered, std::size_t(2 * kSmall.pixels)) << s.name;
        int heldHere = 0;
        std::optional<Certificate> first;
        for (int seed = 0; seed < kSeeds; ++seed) {
            const Certificate stated = certifyWith(s, drawn, std::uint64_t(seed));
            const double mean = truth.shading.mean.value;
            heldHere += stated.shading.mean.low <= mean && mean <= stated.shading.mean.high;
            if (!first)
                first = stated;
        }
        table << tableLine(i + 1, s, truth, *first, heldHere);
        held += heldHere;
    }
    EXPECT_GE(held, 182) << "of 200; see " << (folder / "certificates.md");
}

/// One sphere in a smooth sky, and what was drawn of it.
struct Drawn
{
    CertifiedScene s = certifiedScene(0);
    Image image = draw(s.scene, s.camera, s.settings).color;
};

TEST(Certificate, ExactLightHasNoErrorAndAScaledPictureTheErrorOfItsScale)
{
    Drawn drawn;
    // The exact picture itself, pixel by pixel, from directions of its own.
    const ReferenceSettings exact = exactSettings(drawn.s.settings, {.seed = 5, .directions = 16384});
    const PixelEstimator estimator(drawn.s.scene, drawn.s.camera, exact);
    for (const CoveredPixel& p : coveredPixels(estimator, exact.width, exact.height)) {
        const dvec3 color = estimator.replicates(p.x, p.y, exact.directions, exact.seed).colors.mean();
        for (int c = 0; c < 3; ++c)
            drawn.image.at(p.x, p.y)[c] = static_cast<float>(color[c]);
    }
    const Certificate right = certifyWith(drawn.s, drawn.image, 1);
    EXPECT_LT(right.shading.mean.low, 0.002) << "the exact picture's own noise is 1/8 of a certificate's";
    for (float& value : drawn.image.texels)
        value *= 1.1f;
    const Certificate tenth = certifyWith(drawn.s, drawn.image, 1);
    EXPECT_LE(tenth.shading.mean.low, 0.1);
    EXPECT_GE(tenth.shading.mean.high, 0.1);
    EXPECT_GT(tenth.shading.mean.low, 0.08) << "|1.1 c - c| over c is a tenth in every pixel";
    EXPECT_EQ(tenth.worst->cause.slot, "surface") << "no approximation of an integral explains a scale";
}

TEST(Certificate, NamesTheSlotThatIsWrong)
{
    const CertifiedScene metal = certifiedScene(10), dielectric = certifiedScene(1); // split sum under windows
    const Certificate split = certifyWith(metal, draw(metal.scene, metal.camera, metal.settings).color, 0);
    EXPECT_EQ(split.worst->cause.slot, "environment_specular");
    EXPECT_EQ(split.worst->cause.method, "split_sum");
    CertifiedScene flat = dielectric; // four harmonics under a small sun, hardly any lobe
    flat.scene.materials[0].roughnessFactor = 1.0;
    flat.settings.methods.environmentDiffuse = brdf::findMethod(brdf::Slot::environmentDiffuse, "sh4");
    const Certificate harmonics = certifyWith(flat, draw(flat.scene, flat.camera, flat.settings).color, 0);
    EXPECT_EQ(harmonics.worst->cause.slot, "environment_diffuse");
    EXPECT_EQ(harmonics.worst->cause.method, "sh4");
}

TEST(Certificate, FindsWhatIsForcedAndCountsWhatIsNotFinite)
{
    Drawn drawn;
    const int x = drawn.image.width / 2, y = drawn.image.height / 2;
    drawn.image.at(x, y)[1] = 1000.0f; // the brightest pixel, whether it is drawn at random or not
    drawn.image.at(0, 0)[2] = std::nanf("");
    const Certificate certificate = certifyWith(drawn.s, drawn.image, 3);
    ASSERT_TRUE(certificate.worst);
    EXPECT_EQ(certificate.worst->x, x);
    EXPECT_EQ(certificate.worst->y, y);
    EXPECT_EQ(certificate.nonFinite, 1u) << "a corner that no surface covers";
    EXPECT_NEAR(certificate.worseShare, 3.0 / kSmall.pixels, 0.2 / kSmall.pixels) << "the rule of three";
}

TEST(Certificate, ComparesAllPixelsWhereThereAreNoMore)
{
    const Drawn drawn;
    const Certificate all = certify(drawn.s.scene, drawn.s.camera, drawn.s.settings, drawn.image,
                                    {.pixels = kMostCertified, .directions = 64});
    EXPECT_EQ(all.compared, all.covered);
    EXPECT_EQ(all.worseShare, 0.0);
}

TEST(Certificate, TexturesAreFilteredAsTheyAreDrawn)
{
    // A torus far away, its textures minified to levels 1 to 3, under a lamp: exact light, so that what is left is
    // filtering. Vulkan leaves the level's precision to the device; of level 0 alone the error would be some 10 %.
    Scene scene = texturedTorus();
    for (Texture& texture : scene.textures)
        texture.sampler = Sampler();
    scene.lights.push_back(testLight(Light::Kind::directional));
    const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
    Settings settings = settingsOf("gltf", 48);
    const Image drawn = draw(scene, camera, settings).color;
    const Certificate certificate =
        certify(scene, camera, settings, drawn, {.pixels = kMostCertified, .directions = 64});
    EXPECT_LT(certificate.shading.median.value, 0.02);
}

TEST(Certificate, SaysNothingOfAnEmptyPicture)
{
    Drawn drawn;
    drawn.s.scene.shapes.clear();
    EXPECT_EQ(certifyWith(drawn.s, drawn.image, 0).covered, 0u);
}

} // namespace
} // namespace torrance::test
