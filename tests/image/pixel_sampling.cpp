// One shading a pixel with four samples of depth: the device against the method's formula in double, and the method
// against many samples.
#include "brdf/pixel_sampling.h"
#include "drawing.h"
#include "measure/image_metrics.h"
#include "scene/camera_fit.h"
#include "scene/camera_view.h"
#include "scenes.h"
#include "two_paths.h"

#include <cmath>
#include <gtest/gtest.h>
#include <optional>

namespace torrance::test {
namespace {

constexpr int kSize = 64;

Settings sampled(std::string_view method, Settings settings)
{
    settings.samples = 4;
    settings.methods.pixelSampling = brdf::findMethod(brdf::Slot::pixelSampling, method);
    return settings;
}

/// Squares of half side 1 in space, each of one colour of its own, without light.
struct Squares
{
    Scene scene;
    std::vector<dmat4> places;

    void add(const dvec3& color, const dmat4& place)
    {
        Material material = plainMaterial(color, 0.0, 1.0);
        material.unlit = true;
        material.doubleSided = true;
        scene.materials.push_back(material);
        addInstance(scene, square(static_cast<int>(scene.materials.size()) - 1), place);
        places.push_back(place);
    }
};

/// Turned about X by `tilt`, then about Y by `turn`.
dmat4 placed(const dvec3& at, double turn, double tilt, double scale)
{
    const double c = std::cos(turn), s = std::sin(turn), ct = std::cos(tilt), st = std::sin(tilt);
    dmat4 m = translation(at);
    m[0] = scale * dvec4(c, 0.0, -s, 0.0);
    m[1] = scale * dvec4(s * st, ct, c * st, 0.0);
    m[2] = scale * dvec4(s * ct, -st, c * ct, 0.0);
    return m;
}

/// One before the other with a step of depth, two that meet in a crease, two that cross, and one seen at grazing.
Squares someSquares()
{
    Squares s;
    s.add(dvec3(0.9, 0.1, 0.1), placed({-0.5, 0.45, 0.0}, 0.3, 0.2, 0.6));
    s.add(dvec3(0.1, 0.8, 0.2), placed({-0.2, 0.25, -0.7}, -0.4, 0.1, 0.7));
    s.add(dvec3(0.2, 0.3, 0.9), placed({0.6, -0.4, 0.1}, 0.8, 0.0, 0.5));
    s.add(dvec3(0.9, 0.8, 0.1), placed({0.6, -0.4, 0.1}, -0.7, 0.3, 0.5));
    s.add(dvec3(0.5, 0.1, 0.6), placed({-0.5, -0.75, 0.0}, 0.2, 1.45, 0.6));
    return s;
}

Camera camera(Camera::Kind kind)
{
    Camera c = orbitCamera({0.2, 1.4}, 4.0, dvec3(0), 0.6);
    c.kind = kind;
    c.ymag = 1.25;
    c.nearPlane = 0.5;
    c.farPlane = kind == Camera::Kind::orthographic ? 9.0 : 0.0;
    return c;
}

/// Which square is seen at a point of the picture, in pixels; nothing: none.
std::optional<std::size_t> seenAt(const Squares& s, const Camera& c, const dvec2& p)
{
    const Ray ray = primaryRay(c, kSize, kSize, p.x, p.y);
    std::optional<std::size_t> seen;
    double nearest = 1e300;
    for (std::size_t i = 0; i < s.places.size(); ++i) {
        dmat4 place = s.places[i];
        place[3] = dvec4(dvec3(place[3]) - cameraPosition(c), 1.0);
        const dmat4 inverse = glm::inverse(place);
        const dvec3 from = dvec3(inverse * dvec4(ray.origin, 1.0)), along = dvec3(inverse * dvec4(ray.direction, 0.0));
        const double t = -from.z / along.z;
        const dvec3 hit = from + t * along;
        if (t > 0.0 && t < nearest && std::max(std::abs(hit.x), std::abs(hit.y)) <= 1.0) {
            nearest = t;
            seen = i;
        }
    }
    return seen;
}

/// Reversed depth of a square's plane under a point of the picture.
double depthOf(const Squares& s, const Camera& c, std::size_t index, const dvec2& p)
{
    const Ray ray = primaryRay(c, kSize, kSize, p.x, p.y);
    const dmat4& place = s.places[index];
    const dvec3 normal = glm::normalize(dvec3(place[2])), at = dvec3(place[3]) - cameraPosition(c);
    const double t = glm::dot(at - ray.origin, normal) / glm::dot(ray.direction, normal);
    dmat4 view = viewFromWorld(c);
    view[3] = dvec4(0, 0, 0, 1); // points are relative to the eye
    const dvec4 clip = projectionMatrix(c, 1.0) * view * dvec4(ray.origin + t * ray.direction, 1.0);
    return clip.z / clip.w;
}

/// What the formula is asked about a pixel; nothing where an edge passes so near to one of the points that the device's
/// grid of 1/256 pixel may put it on the other side.
std::optional<brdf::PixelQuery> queryOf(const Squares& s, const Camera& c, const Picture& once, int x, int y)
{
    constexpr double kMargin = 1.0 / 64.0;
    bool certain = true;
    const auto depthAt = [&](const dvec2& p) {
        const auto seen = seenAt(s, c, p);
        for (const dvec2& step : {dvec2(kMargin, 0), dvec2(-kMargin, 0), dvec2(0, kMargin), dvec2(0, -kMargin)})
            certain &= seenAt(s, c, p + step) == seen;
        return seen ? depthOf(s, c, *seen, p) : 0.0;
    };
    const dvec2 center(x + 0.5, y + 0.5);
    brdf::PixelQuery query;
    for (std::size_t i = 0; i < 4; ++i)
        query.sampleDepths[i] = depthAt(center + brdf::kSamplePlaces[i]);
    for (int i = 0; i < 49; ++i)
        query.depths[static_cast<std::size_t>(i)] = depthAt(center + dvec2(i % 7 - 3, i / 7 - 3));
    for (int i = 0; i < 9; ++i)
        query.colors[static_cast<std::size_t>(i)] = pixelOf(once, x + i % 3 - 1, y + i / 3 - 1);
    const bool orthographic = c.kind == Camera::Kind::orthographic;
    const double pixel = orthographic ? 2.0 * c.ymag / kSize : 2.0 * std::tan(0.5 * c.verticalFov) / kSize;
    const dmat4 projection = projectionMatrix(c, 1.0);
    query.widthInDepth = [=](double z) {
        // z = (-P22 d + P32) / w, w = 1 or d: a pixel's width further, less depth.
        const double scale = projection[2][2], offset = projection[3][2];
        if (orthographic)
            return std::abs(scale) * pixel;
        const double d = offset / (z + scale);
        return offset / (d * d) * pixel * d;
    };
    return certain ? std::optional(query) : std::nullopt;
}

TEST(PixelSampling, DeviceAgreesWithTheFormula)
{
    const Squares s = someSquares();
    for (const auto kind : {Camera::Kind::perspective, Camera::Kind::orthographic}) {
        const Camera c = camera(kind);
        const Settings settings = settingsOf("gltf", kSize);
        const Picture once = draw(s.scene, c, settings), drawn = draw(s.scene, c, sampled("reconstructed", settings));
        int mixed = 0, uncertain = 0;
        for (int y = 3; y < kSize - 3; ++y)
            for (int x = 3; x < kSize - 3; ++x) {
                const std::optional<brdf::PixelQuery> query = queryOf(s, c, once, x, y);
                if (!query) {
                    ++uncertain;
                    continue;
                }
                const dvec4 expected = brdf::PS_reconstructed(*query), pixel = pixelOf(drawn, x, y);
                mixed += expected != query->colors[4];
                for (int i = 0; i < 4; ++i)
                    EXPECT_NEAR(pixel[i], expected[i], 1e-6) << x << ' ' << y << " channel " << i;
            }
        EXPECT_GT(mixed, 150) << "edges were compared";
        EXPECT_LT(uncertain, kSize * kSize / 4);
    }
}

TEST(PixelSampling, InsideOfSurfacesThePictureIsThatOfOneSample)
{
    Squares s;
    s.add(dvec3(0.2, 0.5, 0.9), placed({0.1, 0.0, 0.0}, 0.9, 0.4, 0.7));
    const Camera c = camera(Camera::Kind::perspective);
    const Picture once = draw(s.scene, c, settingsOf("gltf", kSize)),
                  drawn = draw(s.scene, c, sampled("reconstructed", settingsOf("gltf", kSize)));
    int covered = 0;
    for (int y = 2; y < kSize - 2; ++y)
        for (int x = 2; x < kSize - 2; ++x) {
            double least = 1.0, most = 0.0;
            for (int i = 0; i < 9; ++i) {
                const double alpha = pixelOf(once, x + i % 3 - 1, y + i / 3 - 1).a;
                least = std::min(least, alpha);
                most = std::max(most, alpha);
            }
            covered += least == 1.0;
            if (least == most) {
                EXPECT_EQ(pixelOf(drawn, x, y), pixelOf(once, x, y)) << x << ' ' << y;
            }
        }
    EXPECT_GT(covered, 300);
}

double errorOf(const Picture& picture, const Picture& truth)
{
    double sum = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < truth.color.texels.size(); ++i) {
        sum += std::pow(double(picture.color.texels[i]) - truth.color.texels[i], 2);
        scale += std::pow(double(truth.color.texels[i]), 2);
    }
    return std::sqrt(sum / scale);
}

// The places of the samples are the box's, those of the truth the filter's: even four whole pictures are off by some.
TEST(PixelSampling, ReconstructedEdgesAreNearerToManySamplesThanOneSampleIs)
{
    const Squares s = someSquares();
    const Camera c = camera(Camera::Kind::perspective);
    const Settings settings = settingsOf("gltf", kSize);
    Settings many = settings;
    many.samples = 256;
    const Picture truth = draw(s.scene, c, many);
    const double one = errorOf(draw(s.scene, c, settings), truth);
    EXPECT_LT(errorOf(draw(s.scene, c, sampled("reconstructed", settings)), truth), 0.5 * one);
}

TEST(PixelSampling, EveryPathReconstructsAlike)
{
    const Scene scene = mixedScene();
    const Camera c = fitCamera(scene, {0.3, 1.3}, 1.0, 0.7, 0.05);
    for (const RenderPath path : {RenderPath::prepass, RenderPath::attributes, RenderPath::deferred}) {
        Settings settings = sampled("reconstructed", settingsOf("standard", 96));
        settings.background = BackgroundKind::color;
        settings.path = path;
        expectForwardPicture(scene, c, settings, "path", 2e-5);
    }
}

// The border lies 0.7 into pixel 8: of its samples, one lies beyond.
TEST(PixelSampling, MaskedEdgesAreReconstructedToo)
{
    constexpr int kPixels = 16;
    const Scene scene = maskedHalf(kPixels, 0.7);
    const Picture drawn = draw(scene, maskedHalfCamera(), sampled("reconstructed", settingsOf("gltf", kPixels)));
    EXPECT_EQ(pixelOf(drawn, 7, 8).a, 1.0);
    EXPECT_EQ(pixelOf(drawn, 8, 8).a, 0.75);
    EXPECT_EQ(pixelOf(drawn, 9, 8).a, 0.0);
}

} // namespace
} // namespace torrance::test
