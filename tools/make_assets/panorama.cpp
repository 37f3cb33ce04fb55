#include "make_assets/panorama.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>

namespace torrance::assets {

dvec3 panoramaDirection(double u, double v)
{
    const double azimuth = (u - 0.5) * 2.0 * kPi;
    const double polar = v * kPi;
    return dvec3(std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth));
}

Image panorama(int width, int height, int grid, const std::function<dvec3(const dvec3&)>& radiance)
{
    Image image(width, height, 3);
    parallelFor(static_cast<std::size_t>(height), 4, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x) {
            dvec3 sum(0.0);
            for (int i = 0; i < grid * grid; ++i) {
                const double u = (x + (i % grid + 0.5) / grid) / width;
                const double v = (y + (i / grid + 0.5) / grid) / height;
                sum += radiance(panoramaDirection(u, v));
            }
            sum /= static_cast<double>(grid * grid);
            for (int c = 0; c < 3; ++c)
                image.at(x, y)[c] = static_cast<float>(sum[c]);
        }
    });
    return image;
}

double texelSolidAngle(int width, int height, int y)
{
    return 2.0 * kPi / width * (std::cos(kPi * y / height) - std::cos(kPi * (y + 1) / height));
}

dvec3 whiteRadiance(const Image& panorama, const dvec3& normal)
{
    dvec3 sum(0.0);
    for (int y = 0; y < panorama.height; ++y) {
        const double solidAngle = texelSolidAngle(panorama.width, panorama.height, y);
        for (int x = 0; x < panorama.width; ++x) {
            const dvec3 direction = panoramaDirection((x + 0.5) / panorama.width, (y + 0.5) / panorama.height);
            const double weight = std::max(0.0, glm::dot(direction, normal)) * solidAngle / kPi;
            const float* texel = panorama.at(x, y);
            sum += weight * dvec3(texel[0], texel[1], texel[2]);
        }
    }
    return sum;
}

} // namespace torrance::assets
