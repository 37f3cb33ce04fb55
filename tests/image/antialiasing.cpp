// N samples per pixel: edges approach the reconstruction filter's own integral, flat regions stay as they are.
#include "drawing.h"
#include "scene/camera_fit.h"
#include "scenes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr int kSize = 16;

/// Integral from -1 to x of the four-term Blackman-Harris window on [-1, 1] (Harris 1978, table 1), normalised; written
/// here again from the paper's coefficients.
double windowIntegral(double x)
{
    const double t = std::clamp(0.5 * (x + 1.0), 0.0, 1.0);
    const double a[] = {0.35875, 0.48829, 0.14128, 0.01168};
    double sum = a[0] * t;
    for (int k = 1; k < 4; ++k)
        sum += (k % 2 == 1 ? -1.0 : 1.0) * a[k] * std::sin(2.0 * kPi * k * t) / (2.0 * kPi * k);
    return sum / a[0];
}

/// A white square that ends `edge` pixels from the picture's left (or top, where turned), seen without perspective.
Picture drawEdge(double edge, bool turned, int samples)
{
    Scene scene;
    Material white = plainMaterial(dvec3(1.0), 0.0, 1.0);
    white.unlit = true;
    scene.materials.push_back(white);
    const double shift = 2.0 * edge / kSize - 2.0; // the square of half side 1 ends at -1 + 2 edge / kSize
    dmat4 m = translation(turned ? dvec3(0, -shift, 0) : dvec3(shift, 0, 0));
    m[turned ? 0 : 1] *= 4.0; // beyond the picture across
    addInstance(scene, square(0), m);
    Camera camera = orbitCamera({}, 3.0, dvec3(0), 0.8);
    camera.kind = Camera::Kind::orthographic;
    camera.ymag = 1.0;
    camera.nearPlane = 0.1;
    camera.farPlane = 10.0;
    Settings settings = settingsOf("gltf", kSize);
    settings.samples = samples;
    return draw(scene, camera, settings);
}

TEST(Antialiasing, EdgesApproachTheFiltersIntegral)
{
    // Every sample has a column and a row of its own 1/N of the filter wide: an edge along an axis is off by 1/N at
    // most.
    for (const bool turned : {false, true})
        for (const int samples : {4, 16, 64})
            for (const double edge : {7.13, 7.5, 7.81}) {
                const Picture picture = drawEdge(edge, turned, samples);
                for (int i = 5; i < 11; ++i) {
                    const dvec4 drawn = turned ? pixelOf(picture, 8, i) : pixelOf(picture, i, 8);
                    EXPECT_NEAR(drawn.a, windowIntegral(edge - (i + 0.5)), 1.0 / samples + 1e-4)
                        << samples << " samples, edge at " << edge << ", pixel " << i << ", turned " << turned;
                    EXPECT_NEAR(drawn.r, drawn.a, 1e-6) << "white, premultiplied";
                }
            }
}

TEST(Antialiasing, OneSampleLiesInThePixelsCentre)
{
    const Picture picture = drawEdge(7.6, false, 1);
    EXPECT_EQ(pixelOf(picture, 7, 8), dvec4(1.0));
    EXPECT_EQ(pixelOf(picture, 8, 8), dvec4(0.0));
}

TEST(Antialiasing, FlatRegionsStayAsTheyAre)
{
    for (const int samples : {4, 16}) {
        const Picture picture = drawEdge(12.0, false, samples);
        for (int x = 0; x < 10; ++x)
            EXPECT_NEAR(pixelOf(picture, x, 8).r, 1.0, samples * 6e-8) << "a sum of " << samples << " roundings";
    }
}

TEST(Antialiasing, MaskedEdgesAreSmoothedToo)
{
    Settings settings = settingsOf("gltf", kSize);
    settings.samples = 16;
    const Scene scene = maskedHalf(kSize, 0.5);
    EXPECT_NEAR(pixelOf(draw(scene, maskedHalfCamera(), settings), 8, 8).a, 0.5, 1.0 / 16 + 1e-4);
}

} // namespace
} // namespace torrance::test
