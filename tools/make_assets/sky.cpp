#include "make_assets/sky.h"

#include "make_assets/panorama.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace torrance::assets {
namespace {

constexpr double kTurbidity = 2.6;       // clear air, a little haze at the horizon
constexpr double kZenithLuminance = 0.3; // what the zenith is scaled to
constexpr double kSunColumn = 0.66;      // to the front and the right: azimuth of u = 0.66
constexpr double kSunRow = 0.29;         // 38 degrees above the horizon
constexpr int kSunGrid = 64;             // directions along each side of a texel that the sun's edge crosses

/// Perez, Seals, Michalsky 1993: how a quantity of the sky varies with the zenith angle and the angle to the sun.
struct Perez
{
    double a, b, c, d, e;
};

double perez(const Perez& p, double cosZenith, double sunAngle)
{
    const double cosSun = std::cos(sunAngle);
    return (1.0 + p.a * std::exp(p.b / cosZenith)) * (1.0 + p.c * std::exp(p.d * sunAngle) + p.e * cosSun * cosSun);
}

// The coefficients for luminance Y and chromaticity x, y as functions of turbidity, and the zenith's chromaticity:
// Preetham, Shirley, Smits 1999, "A Practical Analytic Model for Daylight", appendix A.2.
constexpr double T = kTurbidity;
constexpr Perez kLuminance = {0.1787 * T - 1.4630, -0.3554 * T + 0.4275, -0.0227 * T + 5.3251, 0.1206 * T - 2.5771,
                              -0.0670 * T + 0.3703};
constexpr Perez kChromaX = {-0.0193 * T - 0.2592, -0.0665 * T + 0.0008, -0.0004 * T + 0.2125, -0.0641 * T - 0.8989,
                            -0.0033 * T + 0.0452};
constexpr Perez kChromaY = {-0.0167 * T - 0.2608, -0.0950 * T + 0.0092, -0.0079 * T + 0.2102, -0.0441 * T - 1.6537,
                            -0.0109 * T + 0.0529};

double cubic(double s, double c3, double c2, double c1, double c0)
{
    return ((c3 * s + c2) * s + c1) * s + c0;
}

double zenithX(double s)
{
    return T * T * cubic(s, 0.00166, -0.00375, 0.00209, 0.0) + T * cubic(s, -0.02903, 0.06377, -0.03202, 0.00394) +
           cubic(s, 0.11693, -0.21196, 0.06052, 0.25886);
}

double zenithY(double s)
{
    return T * T * cubic(s, 0.00275, -0.00610, 0.00317, 0.0) + T * cubic(s, -0.04214, 0.08970, -0.04153, 0.00516) +
           cubic(s, 0.15346, -0.26756, 0.06670, 0.26688);
}

/// Linear sRGB (IEC 61966-2-1 primaries) from chromaticity and luminance.
dvec3 rgbFromXyY(double x, double y, double luminance)
{
    const dvec3 xyz(luminance * x / y, luminance, luminance * (1.0 - x - y) / y);
    const dvec3 rgb(3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
                    -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
                    0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z);
    return glm::max(rgb, dvec3(0.0));
}

dvec3 skyRadiance(const dvec3& direction, const dvec3& sun)
{
    // At the horizon the model divides by a cosine of zero: one degree above it is as low as it is asked.
    constexpr double kLowest = 0.0175;
    const double cosZenith = std::max(direction.y, kLowest);
    const double sunZenith = std::acos(sun.y);
    const double sunAngle = std::acos(std::clamp(glm::dot(direction, sun), -1.0, 1.0));
    const auto relative = [&](const Perez& p) { return perez(p, cosZenith, sunAngle) / perez(p, 1.0, sunZenith); };
    return rgbFromXyY(zenithX(sunZenith) * relative(kChromaX), zenithY(sunZenith) * relative(kChromaY),
                      kZenithLuminance * relative(kLuminance));
}

/// A field lit by the sun and the sky, blending into the haze at the horizon.
dvec3 groundRadiance(const dvec3& direction, const dvec3& sun)
{
    const dvec3 field(0.34, 0.30, 0.235);
    const dvec3 horizon = skyRadiance(glm::normalize(dvec3(direction.x, 0.02, direction.z)), sun);
    return glm::mix(horizon, field, std::min(1.0, -direction.y / 0.12));
}

bool insideSun(const dvec3& direction, const dvec3& sun)
{
    return glm::length(direction - sun) <= 2.0 * std::sin(0.5 * kSunAngularRadius);
}

/// The part of a texel that the sun's disc covers.
double sunCoverage(int width, int height, int x, int y, const dvec3& sun)
{
    int inside = 0;
    for (int i = 0; i < kSunGrid * kSunGrid; ++i) {
        const double u = (x + (i % kSunGrid + 0.5) / kSunGrid) / width;
        const double v = (y + (i / kSunGrid + 0.5) / kSunGrid) / height;
        inside += insideSun(panoramaDirection(u, v), sun) ? 1 : 0;
    }
    return static_cast<double>(inside) / (kSunGrid * kSunGrid);
}

void addSun(Image& image, const dvec3& sun)
{
    constexpr int kReach = 4; // texels: wider than the disc in panoramas of up to 2048 columns
    const int centreX = static_cast<int>(kSunColumn * image.width);
    const int centreY = static_cast<int>(kSunRow * image.height);
    std::vector<double> coverage;
    double solidAngle = 0.0;
    for (int y = centreY - kReach; y <= centreY + kReach; ++y)
        for (int x = centreX - kReach; x <= centreX + kReach; ++x) {
            coverage.push_back(sunCoverage(image.width, image.height, x, y, sun));
            solidAngle += coverage.back() * texelSolidAngle(image.width, image.height, y);
        }
    // What the grid missed of the disc's solid angle is put right.
    const double disc = 2.0 * kPi * (1.0 - std::cos(kSunAngularRadius));
    std::size_t next = 0;
    for (int y = centreY - kReach; y <= centreY + kReach; ++y)
        for (int x = centreX - kReach; x <= centreX + kReach; ++x, ++next)
            for (int c = 0; c < 3; ++c)
                image.at(x, y)[c] += static_cast<float>(sunRadiance()[c] * coverage[next] * disc / solidAngle);
}

} // namespace

dvec3 sunRadiance()
{
    return dvec3(1.16e5, 1.08e5, 0.92e5) * 1.1;
}

dvec3 sunDirection(int width, int height)
{
    return panoramaDirection((std::floor(kSunColumn * width) + 0.5) / width,
                             (std::floor(kSunRow * height) + 0.5) / height);
}

Image skyPanorama(int width, int height)
{
    const dvec3 sun = sunDirection(width, height);
    Image image = panorama(width, height, 1, [&](const dvec3& direction) {
        return direction.y >= 0.0 ? skyRadiance(direction, sun) : groundRadiance(direction, sun);
    });
    addSun(image, sun);
    return image;
}

} // namespace torrance::assets
