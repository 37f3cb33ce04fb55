#include "reference/reflected_importance.h"

#include "scene/phong.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

constexpr float kPiF = static_cast<float>(kPi);
// A tile that the horizon crosses counts as if it lay this part of its radius above: some of it does.
constexpr float kLeastHeight = 0.5f;
// The lobe is as much wider as half vectors vary within a tile, about: by half of what directions do, whose standard
// deviation is half of a tile's radius.
constexpr float kSpread = 0.25f;

// A surface as the importance sees it, in the world's axes.
struct Surface
{
    vec3 normal, view;
    float NoV;
    float alpha;
    float f0;
    float body; // albedo / pi
};

float meanOf(const dvec3& color)
{
    return static_cast<float>((color.r + color.g + color.b) / 3.0);
}

Surface surfaceOf(const MaterialPoint& m, const dvec3& view)
{
    const float color = meanOf(m.baseColor), metallic = static_cast<float>(m.metallic);
    return {.normal = vec3(m.normal),
            .view = vec3(view),
            .NoV = std::max(static_cast<float>(glm::dot(m.normal, view)), static_cast<float>(kMinNoV)),
            .alpha = static_cast<float>(m.perceptualRoughness * m.perceptualRoughness),
            .f0 = static_cast<float>(reflectanceOfIor(m.ior)) * (1.0f - metallic) + color * metallic,
            .body = color * (1.0f - metallic) / kPiF};
}

// NoL of the part of the tile that lies above the surface, about; 0 where none does.
float cosineOf(const Surface& s, const EnvironmentSampler::Tile& tile)
{
    const float fromNormal = glm::dot(s.normal, tile.center);
    return fromNormal <= -tile.radius ? 0.0f : std::max(fromNormal, kLeastHeight * tile.radius); // sin x < x
}

// The lobe times NoL. The half vector turns by half of what a direction does; visibility is Hammon's (PBR Diffuse
// Lighting for GGX+Smith Microsurfaces, 2017).
float lobeOf(const Surface& s, const EnvironmentSampler::Tile& tile, float NoL)
{
    if (NoL == 0.0f)
        return 0.0f;
    const float half2 = std::max(2.0f + 2.0f * glm::dot(tile.center, s.view), 0.0f); // |l + v|^2, rounded
    const float NoH2 = std::min((NoL + s.NoV) * (NoL + s.NoV) / half2, 1.0f);
    const float spread = kSpread * tile.radius;
    const float a2 = s.alpha * s.alpha + spread * spread;
    const float d = NoH2 * (a2 - 1.0f) + 1.0f;
    const float D = a2 / (kPiF * d * d);
    const float V = 0.5f / (2.0f * NoL * s.NoV * (1.0f - s.alpha) + (NoL + s.NoV) * s.alpha);
    const float w = 1.0f - std::min(0.5f * std::sqrt(half2), 1.0f), w2 = w * w; // 1 - v.h
    return NoL * D * V * (s.f0 + (1.0f - s.f0) * w2 * w2 * w);
}

} // namespace

std::vector<double> reflectedImportance(std::span<const EnvironmentSampler::Tile> tiles, const MaterialPoint& material,
                                        const dvec3& view)
{
    const Surface surface = surfaceOf(material, view);
    std::vector<float> lobe;
    lobe.reserve(tiles.size());
    float reflected = 0.0f;
    for (const EnvironmentSampler::Tile& tile : tiles) {
        lobe.push_back(lobeOf(surface, tile, cosineOf(surface, tile)));
        reflected += lobe.back() * tile.solidAngle;
    }
    // No lobe reflects more than what arrives; one at grazing angles, smaller than a tile, may seem to.
    const float scale = 1.0f / std::max(reflected, 1.0f);
    std::vector<double> importance;
    importance.reserve(tiles.size());
    for (std::size_t i = 0; i < tiles.size(); ++i)
        importance.push_back(static_cast<double>(surface.body * cosineOf(surface, tiles[i]) + scale * lobe[i]));
    return importance;
}

} // namespace torrance
