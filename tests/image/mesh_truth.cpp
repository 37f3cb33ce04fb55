#include "mesh_truth.h"

#include "reference/shade.h"
#include "scene/camera_view.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

/// Neighbours farther apart than this share of the distance are two surfaces.
constexpr double kDepthStep = 0.1;

CastPixel castPixel(const RayCaster& caster, const brdf::Preset& methods, const Illumination& illumination,
                    const Ray& ray)
{
    const Scene& scene = caster.scene();
    const auto accept = [&](const Hit& hit) { return coverageAt(scene, makeSurfacePoint(caster, ray, hit)) > 0.0; };
    const std::optional<Hit> hit = caster.closest(ray, 0.0, accept);
    if (!hit)
        return {};
    CastPixel pixel;
    pixel.covered = true;
    pixel.surface = makeSurfacePoint(caster, ray, *hit);
    pixel.material = makeMaterialPoint(scene, pixel.surface);
    pixel.radiance =
        shade(methods, illumination, pixel.material, caster.origin(), pixel.surface.position, pixel.surface.view);
    return pixel;
}

bool sameSurface(const CastPixel& a, const CastPixel& b)
{
    if (!a.covered || !b.covered)
        return a.covered == b.covered;
    const double near = std::min(a.surface.distance, b.surface.distance);
    return a.surface.object == b.surface.object &&
           std::abs(a.surface.distance - b.surface.distance) <= kDepthStep * near;
}

void markEdges(std::vector<CastPixel>& cast, int width, int height)
{
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int ny = std::max(0, y - 1); ny <= std::min(height - 1, y + 1); ++ny)
                for (int nx = std::max(0, x - 1); nx <= std::min(width - 1, x + 1); ++nx)
                    if (!sameSurface(cast[static_cast<std::size_t>(y * width + x)],
                                     cast[static_cast<std::size_t>(ny * width + nx)]))
                        cast[static_cast<std::size_t>(y * width + x)].nearEdge = true;
}

double norm1(const dvec3& c)
{
    return std::abs(c.r) + std::abs(c.g) + std::abs(c.b);
}

double meanNorm(const std::vector<CastPixel>& cast)
{
    double sum = 0.0;
    int count = 0;
    for (const CastPixel& p : cast) {
        sum += norm1(p.radiance);
        count += p.covered ? 1 : 0;
    }
    return count > 0 ? sum / count : 0.0;
}

Image castImage(const std::vector<CastPixel>& cast, int width, int height)
{
    Image image(width, height, 4);
    for (std::size_t i = 0; i < cast.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            image.texels[4 * i + c] =
                c < 3 ? static_cast<float>(cast[i].radiance[static_cast<int>(c)]) : (cast[i].covered ? 1.0f : 0.0f);
    return image;
}

} // namespace

std::vector<CastPixel> castPicture(const Scene& scene, const brdf::Preset& methods, const Camera& camera, int width,
                                   int height)
{
    const RayCaster caster(scene, cameraPosition(camera));
    const Illumination illumination{
        scene.lights, scene.environment ? uniformRadiance(*scene.environment).value_or(dvec3(0.0)) : dvec3(0.0)};
    std::vector<CastPixel> cast;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            cast.push_back(
                castPixel(caster, methods, illumination, primaryRay(camera, width, height, x + 0.5, y + 0.5)));
    markEdges(cast, width, height);
    return cast;
}

Agreement compareToCast(const Picture& picture, const std::vector<CastPixel>& cast, double tolerance)
{
    const double floor = 0.01 * meanNorm(cast);
    Agreement agreement;
    std::vector<double> errors;
    for (std::size_t i = 0; i < cast.size(); ++i) {
        if (cast[i].nearEdge)
            continue;
        const int x = static_cast<int>(i) % picture.color.width;
        const int y = static_cast<int>(i) / picture.color.width;
        const dvec4 drawn = pixelOf(picture, x, y);
        agreement.coverageErrors += (drawn.a == 1.0) == cast[i].covered ? 0 : 1;
        if (!cast[i].covered)
            continue;
        errors.push_back(norm1(dvec3(drawn) - cast[i].radiance) / (norm1(cast[i].radiance) + floor));
        agreement.worst.note(x, y, dvec3(drawn), cast[i].radiance,
                             dvec3(tolerance * (norm1(cast[i].radiance) + floor)));
    }
    agreement.compared = static_cast<int>(errors.size());
    if (errors.empty())
        return agreement;
    const auto rank = errors.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(errors.size() - 1));
    std::nth_element(errors.begin(), rank, errors.end());
    agreement.percentile99 = *rank;
    return agreement;
}

void expectDrawnAsCast(const Scene& scene, const Camera& camera, const Settings& settings, double tolerance,
                       const std::string& name)
{
    const Picture picture = draw(scene, camera, settings);
    const std::vector<CastPixel> cast =
        castPicture(scene, plannedMethods(scene, settings, 0), camera, settings.width, settings.height);
    const Agreement agreement = compareToCast(picture, cast, tolerance);
    const bool good = agreement.percentile99 <= tolerance && agreement.coverageErrors == 0;
    EXPECT_GT(agreement.compared, settings.width * settings.height / 10) << name << ": hardly anything to compare";
    EXPECT_TRUE(good) << name << ": 99th percentile " << agreement.percentile99 << ", " << agreement.coverageErrors
                      << " pixels differ in coverage, " << agreement.worst.text() << "; see "
                      << keepFailure(name, picture.color, castImage(cast, settings.width, settings.height));
}

} // namespace torrance::test
