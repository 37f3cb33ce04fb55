#include "study/pixel_sample.h"

#include "core/error.h"
#include "core/parallel.h"
#include "math/scrambled_sequence.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace torrance {
namespace {

constexpr int kTile = 16; // pixels along the side

float cosineOfView(const RayCaster& rays, const Ray& ray, const Hit& hit)
{
    dvec3 normal;
    if (hit.shape >= 0) {
        normal = makeSurfacePoint(rays, ray, hit).geometricNormal;
    } else {
        const std::array<dvec3, 3> corners = triangleCorners(rays.scene(), hit.instance, hit.triangle, rays.origin());
        normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        normal /= std::max(glm::length(normal), 1e-300); // an area of 0 is no triangle that is met
    }
    return static_cast<float>(std::abs(glm::dot(normal, ray.direction)));
}

std::vector<CoveredPixel> coveredOfTile(const PixelEstimator& estimator, int left, int top, int width, int height)
{
    std::vector<CoveredPixel> covered;
    for (int y = top; y < std::min(top + kTile, height); ++y)
        for (int x = left; x < std::min(left + kTile, width); ++x)
            if (const std::optional<Hit> hit = estimator.seenFrom(x, y))
                covered.push_back({x, y, materialIndexOf(estimator.rays().scene(), *hit),
                                   cosineOfView(estimator.rays(), estimator.rayAt(x + 0.5, y + 0.5), *hit)});
    return covered;
}

/// `count` different numbers below `population`, ascending (Floyd's algorithm: Bentley & Floyd, A Sample of
/// Brilliance, 1987).
std::vector<std::size_t> choose(std::size_t population, std::size_t count, std::uint64_t key)
{
    std::vector<std::size_t> chosen;
    for (std::size_t last = population - count; last < population; ++last) {
        const std::size_t any = static_cast<std::size_t>(hashNumbers({key, last}) % (last + 1)); // bias below 2^-40
        const bool taken = std::ranges::find(chosen, any) != chosen.end();
        chosen.push_back(taken ? last : any);
    }
    std::ranges::sort(chosen);
    return chosen;
}

std::string materialName(const Scene& scene, int material)
{
    if (material < 0)
        return "glTF's default";
    const std::string& name = scene.materials[static_cast<std::size_t>(material)].name;
    return name.empty() ? "number " + std::to_string(material) : oneLine(name);
}

} // namespace

std::vector<CoveredPixel> coveredPixels(const PixelEstimator& estimator, int width, int height)
{
    const int across = (width + kTile - 1) / kTile, down = (height + kTile - 1) / kTile;
    std::vector<std::vector<CoveredPixel>> tiles(static_cast<std::size_t>(across) * static_cast<std::size_t>(down));
    parallelFor(tiles.size(), 1, [&](std::size_t i) {
        const int tile = static_cast<int>(i);
        tiles[i] = coveredOfTile(estimator, tile % across * kTile, tile / across * kTile, width, height);
    });
    std::vector<CoveredPixel> covered;
    for (const auto& tile : tiles)
        covered.insert(covered.end(), tile.begin(), tile.end());
    return covered;
}

std::vector<PixelStratum> drawSample(std::size_t population, std::size_t count, std::uint64_t seed)
{
    const std::size_t drawn = std::min(population, count);
    const std::size_t strata = drawn < population ? drawn / 2 : 1;
    std::vector<PixelStratum> sample;
    for (std::size_t i = 0; i < strata; ++i) {
        const std::size_t first = population * i / strata, end = population * (i + 1) / strata;
        const std::size_t share = i + 1 < strata ? 2 : drawn - 2 * (strata - 1);
        PixelStratum stratum = {end - first, choose(end - first, share, hashNumbers({seed, i}))};
        for (std::size_t& pixel : stratum.drawn)
            pixel += first;
        sample.push_back(std::move(stratum));
    }
    return sample;
}

std::vector<ForcedPixel> forcedPixels(const Scene& scene, const std::vector<CoveredPixel>& covered, const Image& drawn,
                                      std::uint64_t seed)
{
    std::map<int, std::pair<std::uint64_t, std::size_t>> ofMaterial; // least hash, and its pixel
    std::size_t brightest = 0, grazing = 0;
    float most = -1.0f;
    for (std::size_t i = 0; i < covered.size(); ++i) {
        const CoveredPixel& pixel = covered[i];
        const std::pair<std::uint64_t, std::size_t> ticket = {hashNumbers({seed, i}), i};
        const auto [place, isNew] = ofMaterial.try_emplace(pixel.material, ticket);
        if (!isNew)
            place->second = std::min(place->second, ticket);
        const float* color = drawn.at(pixel.x, pixel.y);
        const float sum = color[0] + color[1] + color[2];
        if (sum > most) { // never true of NaN, which is counted by itself
            most = sum;
            brightest = i;
        }
        if (pixel.NoV < covered[grazing].NoV)
            grazing = i;
    }
    std::vector<ForcedPixel> forced;
    for (const auto& [material, ticket] : ofMaterial)
        forced.push_back({ticket.second, "material " + materialName(scene, material)});
    forced.push_back({brightest, "the brightest"});
    forced.push_back({grazing, "the most grazing"});
    return forced;
}

} // namespace torrance
