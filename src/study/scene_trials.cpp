#include "study/scene_trials.h"

#include "image/display.h"
#include "measure/heat_map.h"
#include "measure/image_metrics.h"
#include "scene/camera_fit.h"
#include "scene/camera_view.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

// What is known of the picture before anything is changed.
struct Base
{
    const Subject& subject;
    const DrawScene& draw;
    Image picture;
    double size;              // of the scene's bounds, metres
    double distance;          // from the camera to their centre
    double changePerPixel;    // mean error of a picture that is moved by a pixel, over that
    std::vector<Image> moved; // by parts of a pixel
};

constexpr dvec2 kShifts[] = {{0.25, 0.0}, {-0.125, 0.375}, {0.0, -0.25}, {0.375, 0.125}, {-0.375, -0.375}};

// Shading: some forty float operations of 2^-24 each.
constexpr double kShadingRounding = 5e-6;
// Positions and matrices are floats relative to the eye: eight roundings of the picture's width each.
constexpr double kPositionRoundings = 8.0;
// The plan leaves compensation out where it adds less than a thousandth of the light.
constexpr double kCompensationThreshold = 1e-3;

double roundingBound(const Base& base, double worldRounding)
{
    const double pixels =
        base.picture.width * (kPositionRoundings * 0x1p-24 + worldRounding / std::max(base.distance, 1e-12));
    return kShadingRounding + pixels * base.changePerPixel;
}

Image colorsOf(const Image& picture)
{
    Image colors(picture.width, picture.height, 3);
    for (std::size_t i = 0; i < colors.texels.size() / 3; ++i)
        std::copy_n(&picture.texels[4 * i], 3, &colors.texels[3 * i]);
    return colors;
}

HtmlPicture shown(const Image& picture, const std::string& caption)
{
    return {toDisplay(picture, {.alpha = AlphaRule::overBlack}), caption, 1};
}

// Of the relative difference, a decade per eighth from 1e-8.
HtmlPicture difference(const Image& a, const Image& b, const std::string& caption)
{
    Image error(a.width, a.height, 1);
    for (std::size_t i = 0; i < error.texels.size(); ++i) {
        double apart = 0, size = 1e-6;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            apart += std::abs(double(a.texels[4 * i + channel]) - b.texels[4 * i + channel]);
            size += std::abs(double(b.texels[4 * i + channel]));
        }
        error.texels[i] = apart > 0 ? static_cast<float>(std::log10(apart / size) / 8 + 1) : 0.0f;
    }
    return {heatMap(error), caption + ": log10 of the relative difference, black 1e-8, pale yellow 1", 1};
}

double meanError(const Image& test, const Image& reference)
{
    const ImageMetrics metrics = compareImages(colorsOf(reference), colorsOf(test));
    return metrics.nonFiniteTest > 0 ? NAN : metrics.meanError;
}

int badPixels(const Image& picture)
{
    int bad = 0;
    for (std::size_t i = 0; i < picture.texels.size(); i += 4) {
        const auto isBad = [](float value) { return !std::isfinite(value) || value < 0; };
        bad += std::any_of(&picture.texels[i], &picture.texels[i] + 4, isBad) ? 1 : 0;
    }
    return bad;
}

double brightest(const Image& picture)
{
    double greatest = 0.0;
    for (std::size_t i = 0; i < picture.texels.size(); ++i)
        if (i % 4 != 3 && !(picture.texels[i] <= greatest))
            greatest = picture.texels[i];
    return greatest;
}

SceneTrial notApplicable(std::string name, std::string missing)
{
    SceneTrial trial;
    trial.name = std::move(name);
    trial.expectation = "Not asked: " + missing + ".";
    trial.quantity = std::move(missing);
    trial.applies = false;
    return trial;
}

SceneTrial sameAs(std::string name, std::string expectation, const Image& test, const Image& reference, double allowed)
{
    return {.name = std::move(name),
            .expectation = std::move(expectation),
            .quantity = "mean error, of the reference's mean",
            .measured = meanError(test, reference),
            .allowed = allowed,
            .pictures = {shown(reference, "as it must be"), shown(test, "as it is"),
                         difference(test, reference, "between them")}};
}

SceneTrial finite(std::string name, std::string expectation, const Image& picture)
{
    return {.name = std::move(name),
            .expectation = std::move(expectation),
            .quantity = "pixels with a value that is not finite or below 0",
            .measured = static_cast<double>(badPixels(picture)),
            .allowed = 0,
            .pictures = {shown(picture, "as it is")}};
}

// A quantity that enters linearly: half way it must be the mean of the ends.
SceneTrial halfWay(std::string name, std::string expectation, const Image& none, const Image& half, const Image& all,
                   double allowed)
{
    Image mean = none;
    for (std::size_t i = 0; i < mean.texels.size(); ++i)
        mean.texels[i] = 0.5f * (none.texels[i] + all.texels[i]);
    SceneTrial trial = sameAs(std::move(name), std::move(expectation), half, mean, allowed);
    trial.pictures.push_back(shown(none, "at 0"));
    trial.pictures.push_back(shown(all, "at 1"));
    return trial;
}

Base measuredBase(const Subject& subject, const DrawScene& draw)
{
    const Bounds bounds = worldBounds(subject.scene);
    const double size = std::max(glm::length(bounds.max - bounds.min), 1e-12);
    const double distance = glm::length(0.5 * (bounds.min + bounds.max) - cameraPosition(subject.camera));
    Base base = {.subject = subject,
                 .draw = draw,
                 .picture = draw(subject.scene, subject.camera),
                 .size = size,
                 .distance = distance,
                 .changePerPixel = 0.0,
                 .moved = {}};
    double change = 0, pixels = 0;
    for (const dvec2& shift : kShifts) {
        base.moved.push_back(
            draw(subject.scene, shiftedByPixels(subject.camera, shift, base.picture.height, distance)));
        change += meanError(base.moved.back(), base.picture);
        pixels += glm::length(shift);
    }
    base.changePerPixel = change / pixels;
    return base;
}

// The least and the greatest luminance of a pixel and its eight neighbours.
struct Range
{
    double least = HUGE_VAL, greatest = -HUGE_VAL;
};

double luminance(const Image& picture, int x, int y)
{
    const float* texel = picture.at(x, y);
    return 0.2126 * texel[0] + 0.7152 * texel[1] + 0.0722 * texel[2];
}

Range neighbourhood(const Image& picture, int x, int y)
{
    Range range;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, picture.height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, picture.width - 1); ++u) {
            range.least = std::min(range.least, luminance(picture, u, v));
            range.greatest = std::max(range.greatest, luminance(picture, u, v));
        }
    return range;
}

constexpr double kSparkle = 0.1;       // of the brightest neighbour
constexpr double kSparkleShare = 0.02; // of the covered pixels

// A picture that resolves what it shows takes no values, when it moves by less than half a pixel, that its neighbours
// do not have: highlights and texels narrower than a pixel do.
SceneTrial sparkle(const Base& base)
{
    const Image& picture = base.picture;
    Image deviation(picture.width, picture.height, 1);
    double sparkling = 0, covered = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            if (picture.at(x, y)[3] == 0)
                continue;
            covered += 1;
            const Range range = neighbourhood(picture, x, y);
            double beyond = 0, squares = 0;
            for (const Image& moved : base.moved) {
                const double value = luminance(moved, x, y);
                beyond = std::max({beyond, value - range.greatest, range.least - value});
                squares += (value - luminance(picture, x, y)) * (value - luminance(picture, x, y));
            }
            sparkling += beyond > kSparkle * range.greatest ? 1 : 0;
            *deviation.at(x, y) = static_cast<float>(std::sqrt(squares / static_cast<double>(base.moved.size())) /
                                                     (range.greatest + 1e-6));
        }
    return {.name = "camera moved by parts of a pixel",
            .expectation =
                "A picture that resolves what it shows takes, when the camera moves by less than half a pixel, "
                "no values outside of those of neighbouring pixels. Counted are pixels that pass them by more "
                "than a tenth: specular sparkle, and detail finer than a pixel. Two in a hundred are allowed "
                "for edges of a few pixels' curvature.",
            .quantity = "share of the covered pixels",
            .measured = covered > 0 ? sparkling / covered : 0.0,
            .allowed = kSparkleShare,
            .pictures = {shown(picture, "unmoved"),
                         {heatMap(deviation),
                          "standard deviation over the shifts, of the "
                          "brightest neighbour, black 0 to pale yellow 1",
                          1}}};
}

SceneTrial scaleTrial(const Base& base, double factor)
{
    const Subject changed = scaled(base.subject, factor);
    return sameAs(
        fmt::format("scale {:g}", factor),
        "All lengths times the factor, and lights of a place brighter by its square: the same picture. Allowed "
        "is float rounding of shading and of positions relative to the eye, as far as a movement of so many "
        "pixels changes this picture.",
        base.draw(changed.scene, changed.camera), base.picture, roundingBound(base, 0.0));
}

SceneTrial translationTrial(const Base& base)
{
    const double offset = 1e6;
    const Subject changed = translated(base.subject, dvec3(offset, -offset, 0.5 * offset));
    return sameAs("everything moved by 1e6 m",
                  "Transforms are relative to the camera: the same picture. Allowed is the rounding of the world's "
                  "coordinates in double, and that of floats relative to the eye.",
                  base.draw(changed.scene, changed.camera), base.picture, roundingBound(base, 4 * offset * 0x1p-52));
}

Light pointLight(const dvec3& position, double candela)
{
    Light light;
    light.kind = Light::Kind::point;
    light.position = position;
    light.intensity = candela;
    return light;
}

// A place on the surface: of the vertex, or of the sphere's pole, nearest to the camera.
dvec3 placeOnSurface(const Subject& subject)
{
    const dvec3 eye = cameraPosition(subject.camera);
    dvec3 nearest(0.0);
    double least = HUGE_VAL;
    const auto consider = [&](const dvec3& place) {
        const double distance = glm::length(place - eye);
        if (distance < least) {
            least = distance;
            nearest = place;
        }
    };
    for (const Instance& instance : subject.scene.instances)
        for (const vec3& position : subject.scene.primitives[static_cast<std::size_t>(instance.primitive)].positions)
            consider(dvec3(instance.worldFromObject * dvec4(dvec3(position), 1.0)));
    for (const AnalyticShape& shape : subject.scene.shapes) {
        const dvec3 center = dvec3(shape.worldFromObject[3]);
        const double radius = glm::length(dvec3(shape.worldFromObject[0]));
        consider(shape.kind == AnalyticShape::Kind::sphere ? center + radius * glm::normalize(eye - center) : center);
    }
    return nearest;
}

Scene litBy(const Scene& scene, const Light& light)
{
    Scene lit = scene;
    lit.environment.reset();
    lit.lights = {light};
    return lit;
}

SceneTrial lightOnSurface(const Base& base)
{
    const Scene lit = litBy(base.subject.scene, pointLight(placeOnSurface(base.subject), 1.0));
    return finite(
        "point light on a surface",
        "A light at distance 0 of what it lights: finite, not negative, by the least distance that the shader "
        "keeps.",
        base.draw(lit, base.subject.camera));
}

SceneTrial distantLight(const Base& base)
{
    const dvec3 towards = glm::normalize(dvec3(0.4, 0.8, 0.45));
    const double distance = 1e8 * base.size;
    const Scene near = litBy(base.subject.scene, pointLight(towards * distance, distance * distance));
    Light sun;
    sun.direction = -towards;
    const Scene far = litBy(base.subject.scene, sun);
    const double parallax = 1e-7; // the scene's size, and its place, over the distance, magnified by highlights
    return sameAs(
        "point light 1e8 sizes away", "So far away, a point light of d^2 candela is a directional light of 1 lux.",
        base.draw(near, base.subject.camera), base.draw(far, base.subject.camera), kShadingRounding + 100 * parallax);
}

SceneTrial brightTexel(const Base& base)
{
    const double radiance = 0.5, texel = 2e6;
    Scene lit = base.subject.scene;
    lit.lights.clear();
    lit.environment = environmentWithSpot(radiance, texel);
    for (Material& material : lit.materials)
        material.emissiveFactor = dvec3(0.0);
    const Image picture = base.draw(lit, base.subject.camera);
    return {.name = "environment with one texel of 1e6",
            .expectation =
                "Finite, not negative, and nothing brighter than twice the brightest texel: the diffuse and the "
                "specular part each return no more than they receive.",
            .quantity = "brightest channel, of the brightest texel",
            .measured = (badPixels(picture) > 0 ? NAN : brightest(picture)) / (radiance * texel),
            .allowed = 2.0,
            .pictures = {shown(picture, "as it is")}};
}

bool hasUvs(const Scene& scene)
{
    return std::ranges::any_of(scene.primitives, [](const Primitive& p) { return !p.uvs[0].empty(); });
}

SceneTrial mirroredUvs(const Base& base)
{
    const char* name = "mirrored texture coordinates";
    Scene mirrored = base.subject.scene;
    if (!hasUvs(mirrored))
        return notApplicable(name, "no texture coordinates");
    if (!mirrorUvs(mirrored))
        return notApplicable(name, "a picture serves as normal map and as something else");
    // 1 - u rounds to 2^-24 of the map, up to a hundredth of a texel of 2^17.
    return sameAs(name, "Maps, coordinates and tangents mirrored together: the same picture.",
                  base.draw(mirrored, base.subject.camera), base.picture, 10 * roundingBound(base, 0.0));
}

SceneTrial collapsedUvs(const Base& base)
{
    Scene collapsed = base.subject.scene;
    if (!hasUvs(collapsed))
        return notApplicable("degenerate texture coordinates", "no texture coordinates");
    collapseUvs(collapsed);
    return finite("degenerate texture coordinates",
                  "Triangles without area in the map: finite, not negative, one colour of each map.",
                  base.draw(collapsed, base.subject.camera));
}

SceneTrial normalsBelow(const Base& base)
{
    Scene below = base.subject.scene;
    if (!hasUvs(below))
        return notApplicable("normal map below the horizon", "no texture coordinates");
    turnNormalsBelow(below);
    return finite("normal map below the horizon",
                  "Normals that point into the surface are bent until they are seen: finite, not negative.",
                  base.draw(below, base.subject.camera));
}

void addSmoothTrials(std::vector<SceneTrial>& trials, const Base& base)
{
    Scene smooth = base.subject.scene;
    setRoughness(smooth, 0.0);
    const dvec3 eye = cameraPosition(base.subject.camera);
    const auto add = [&](const std::string& name, const Scene& scene) {
        trials.push_back(finite("roughness 0, " + name, "A mirror has a finite highlight, of alpha 1e-4.",
                                base.draw(scene, base.subject.camera)));
    };
    Light light;
    light.direction = -dvec3(base.subject.camera.worldFromCamera[2]);
    add("directional light", litBy(smooth, light));
    light = pointLight(eye, base.distance * base.distance);
    add("point light", litBy(smooth, light));
    light.radius = 0.05 * base.distance;
    add("point light with a radius", litBy(smooth, light));
    light = pointLight(eye, base.distance * base.distance);
    light.kind = Light::Kind::spot;
    light.direction = -dvec3(base.subject.camera.worldFromCamera[2]);
    add("spot light", litBy(smooth, light));
    Scene environment = smooth;
    environment.lights.clear();
    if (environment.environment)
        add("environment", environment);
}

SceneTrial metallicTrial(const Base& base)
{
    const auto at = [&](double metallic) {
        Scene scene = base.subject.scene;
        setMetallic(scene, metallic);
        return base.draw(scene, base.subject.camera);
    };
    return halfWay(
        "metallic between 0 and 1",
        "A dielectric and a metal are mixed as colours: at 1/2 the picture is the mean of both. Allowed is the "
        "compensation that the plan leaves out at 0, a thousandth of the light.",
        at(0.0), at(0.5), at(1.0), kCompensationThreshold + kShadingRounding);
}

// Fresnel terms rise with the index everywhere: of a black body, no pixel is brighter at 1 than at 1.5.
SceneTrial indexOfOne(const Base& base)
{
    const auto at = [&](double ior) {
        Scene scene = base.subject.scene;
        leaveInterface(scene, ior);
        return base.draw(scene, base.subject.camera);
    };
    const Image none = at(1.0), glass = at(1.5);
    double excess = badPixels(none) > 0 ? NAN : 0.0, left = 0.0, whole = 0.0;
    for (std::size_t i = 0; i < none.texels.size(); ++i)
        if (i % 4 != 3) {
            left += none.texels[i];
            whole += glass.texels[i];
            if (!(none.texels[i] - glass.texels[i] <= excess))
                excess = double(none.texels[i]) - glass.texels[i];
        }
    const double share = whole > 0 ? left / whole : 0.0;
    return {.name = "index of refraction 1",
            .expectation = fmt::format("Over a black body there is no interface left: finite, not negative, and "
                                       "nowhere brighter than with the index 1.5. What is still reflected, {:.1f} % of "
                                       "the light at 1.5, is the grazing rise of Schlick's term at F0 = 0.",
                                       100.0 * share),
            .quantity = "greatest channel above that at 1.5, of the brightest there",
            .measured = excess / std::max(brightest(glass), 1e-30),
            .allowed = kShadingRounding,
            .pictures = {shown(none, "index 1"), shown(glass, "index 1.5")}};
}

void addOcclusionTrials(std::vector<SceneTrial>& trials, const Base& base)
{
    Scene none = base.subject.scene, half = none, all = none, without = none;
    if (!setOcclusionStrength(none, 0.0)) {
        trials.push_back(notApplicable("occlusion strength", "no occlusion texture"));
        return;
    }
    setOcclusionStrength(half, 0.5);
    setOcclusionStrength(all, 1.0);
    removeOcclusion(without);
    const Camera& camera = base.subject.camera;
    const Image atNone = base.draw(none, camera);
    trials.push_back(sameAs("occlusion strength 0", "The picture without the occlusion texture.", atNone,
                            base.draw(without, camera), kShadingRounding));
    trials.push_back(halfWay("occlusion strength 1/2", "The strength enters linearly: the mean of 0 and 1.", atNone,
                             base.draw(half, camera), base.draw(all, camera), kShadingRounding));
}

} // namespace

std::vector<SceneTrial> runSceneTrials(const Subject& subject, const DrawScene& draw,
                                       const std::function<void(int, int)>& progress)
{
    constexpr int kSteps = 6;
    int done = 0;
    const auto step = [&] { progress(done++, kSteps); };
    step();
    const Base base = measuredBase(subject, draw);
    std::vector<SceneTrial> trials = {finite("as it is", "Finite, not negative.", base.picture), sparkle(base)};
    step();
    for (const double factor : {1e-4, 1e-2, 1e3, 1e6})
        trials.push_back(scaleTrial(base, factor));
    trials.push_back(translationTrial(base));
    step();
    for (const auto& trial : {lightOnSurface, distantLight, brightTexel})
        trials.push_back(trial(base));
    step();
    for (const auto& trial : {mirroredUvs, collapsedUvs, normalsBelow})
        trials.push_back(trial(base));
    step();
    addSmoothTrials(trials, base);
    step();
    trials.push_back(metallicTrial(base));
    trials.push_back(indexOfOne(base));
    addOcclusionTrials(trials, base);
    return trials;
}

} // namespace torrance
