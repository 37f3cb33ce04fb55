#include "make_assets/worn_copper.h"

#include "core/atomic_write.h"
#include "core/parallel.h"
#include "files/image_encoders.h"
#include "make_assets/noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace torrance::assets {
namespace {

constexpr int kSize = 512;
constexpr int kBlotches = 5;            // of patina, along each side of the tile
constexpr double kPatinaHeight = 0.004; // tile widths

double ramp(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// 0 where the copper is bare, 1 under whole patina.
double patina(double u, double v)
{
    const double broad = cloudNoise(u * kBlotches, v * kBlotches, kBlotches, kBlotches, 81);
    const double grain = cloudNoise(u * 60, v * 60, 60, 60, 82);
    return ramp(0.42, 0.58, broad + 0.25 * (grain - 0.5));
}

/// Long fine scratches, mostly along u: 1 in their middle.
double scratches(double u, double v)
{
    const double bent = v + 0.01 * std::sin(2.0 * kPi * u);
    const double lines = smoothNoise(u * 3, bent * 190, 3, 190, 83);
    return ramp(0.86, 0.95, lines);
}

double heightAt(double u, double v)
{
    const double crust = cloudNoise(u * 40, v * 40, 40, 40, 84);
    return kPatinaHeight * patina(u, v) * (0.6 + 0.4 * crust) - 0.0006 * scratches(u, v);
}

dvec3 normalAt(double u, double v)
{
    const double step = 0.75 / kSize;
    const double slopeU = (heightAt(u + step, v) - heightAt(u - step, v)) / (2.0 * step);
    const double slopeV = (heightAt(u, v + step) - heightAt(u, v - step)) / (2.0 * step);
    return glm::normalize(dvec3(-slopeU, slopeV, 1.0)); // v runs down, the map's green points up
}

/// What the neighbourhood's patina takes of the light, at a distance of some times its height.
double occlusionAt(double u, double v)
{
    constexpr double kReach = 0.012; // tile widths
    constexpr int kDirections = 8;
    double higher = 0.0;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = 2.0 * kPi * i / kDirections;
        higher += patina(u + kReach * std::cos(angle), v + kReach * std::sin(angle)) / kDirections;
    }
    return 1.0 - 0.5 * std::max(higher - patina(u, v), 0.0);
}

} // namespace

WornCopper wornCopper(double u, double v)
{
    const dvec3 copper(0.978, 0.821, 0.757); // 0.95 0.64 0.54 in linear light
    const dvec3 light(0.52, 0.73, 0.66), dark(0.24, 0.33, 0.29);
    const double cover = patina(u, v);
    const double stain = cloudNoise(u * 9, v * 9, 9, 9, 85);
    const double scratch = scratches(u, v);
    const double bareness = 1.0 - cover * (1.0 - 0.8 * scratch);
    const dvec3 crust = dark * (1.0 - stain) + light * stain;
    const dvec3 metal = copper * (0.86 + 0.14 * cloudNoise(u * 7, v * 7, 7, 7, 86));
    const double polished = 0.18 + 0.22 * cloudNoise(u * 12, v * 12, 12, 12, 87) + 0.15 * scratch;
    return {.color = crust * (1.0 - bareness) + metal * bareness,
            .roughness = (0.72 + 0.2 * stain) * (1.0 - bareness) + polished * bareness,
            .metallic = bareness,
            .normal = normalAt(u, v),
            .occlusion = occlusionAt(u, v)};
}

void writeWornCopper(const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder);
    std::vector<WornCopper> texels(static_cast<std::size_t>(kSize) * kSize);
    parallelFor(texels.size(), kSize, [&](std::size_t i) {
        const auto column = static_cast<double>(i % kSize), row = static_cast<double>(i / kSize);
        texels[i] = wornCopper((column + 0.5) / kSize, (row + 0.5) / kSize);
    });
    const auto write = [&](const char* map, int channels, int bits, const auto& valueOf) {
        const Image picture = makePicture(kSize, kSize, channels, [&](double u, double v) {
            const auto column = static_cast<std::size_t>(u * kSize), row = static_cast<std::size_t>(v * kSize);
            return dvec4(valueOf(texels[row * kSize + column]), 1.0);
        });
        writeFile(folder / ("worn_copper_" + std::string(map) + ".png"), encodePng(picture, bits));
    };
    write("Color", 3, 8, [](const WornCopper& t) { return t.color; });
    write("Roughness", 1, 16, [](const WornCopper& t) { return dvec3(t.roughness); });
    write("Metalness", 1, 16, [](const WornCopper& t) { return dvec3(t.metallic); });
    write("NormalGL", 3, 16, [](const WornCopper& t) { return 0.5 * t.normal + 0.5; });
    write("AmbientOcclusion", 1, 8, [](const WornCopper& t) { return dvec3(t.occlusion); });
}

} // namespace torrance::assets
