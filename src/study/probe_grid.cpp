#include "study/probe_grid.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>

namespace torrance {
namespace {

using namespace brdf;

class Random
{
public:
    double uniform(double from, double to) { return from + (to - from) * (static_cast<double>(engine()) / 0x1p64); }
    dvec3 direction() { return directionAt(uniform(-1, 1), uniform(0, 2 * kPi)); }
    dvec3 color() { return {uniform(0, 1), uniform(0, 1), uniform(0, 1)}; }

private:
    std::mt19937_64 engine{20240607};
};

void giveMaterial(ShadingPoint& point, Random& random)
{
    point.baseColor = random.color();
    if (random.uniform(0, 1) < 0.3)
        point.baseColor = glm::round(point.baseColor); // black and saturated metals
    point.metallic = std::clamp(random.uniform(-0.3, 1.3), 0.0, 1.0);
    point.f0 = random.color();
    point.ior = random.uniform(0.4, 3.0);
    point.eta = random.color() * 4.0 + 0.05;
    point.k = random.color() * 8.0;
    point.f82 = random.color();
    setAnisotropy(point, random.direction(), random.uniform(0, 1));
    point.E = random.uniform(0.3, 1.0);
    point.bias = point.E * random.uniform(0.0, 1.0);
    point.ELight = random.uniform(0.3, 1.0);
    point.EAverage = random.uniform(0.4, 1.0);
    for (dvec3* color : {&point.single, &point.F, &point.FNoV, &point.FNoL, &point.lobeAlbedo})
        *color = random.color();
}

// Turns the +Z axis into n.
dvec3 turned(const dvec3& n, const dvec3& d)
{
    const dvec3 t = glm::normalize(glm::cross(std::abs(n.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0), n));
    return t * d.x + glm::cross(n, t) * d.y + n * d.z;
}

} // namespace

dvec3 directionAt(double cosine, double azimuth)
{
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

std::vector<ShadingPoint> probeGrid()
{
    std::vector<ShadingPoint> rows;
    Random random;
    const dvec3 tilted = glm::normalize(dvec3(0.3, -0.7, 0.5));
    for (const dvec3& n : {dvec3(0, 0, 1), tilted})
        for (const double r : {0.01, 0.014, 0.02, 0.03, 0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0})
            for (const double NoV : {0.005, 0.05, 0.2, 0.5, 0.8, 0.97, 1.0})
                for (const double NoL : {0.005, 0.05, 0.2, 0.5, 0.8, 0.97, 1.0})
                    for (const double azimuth : {0.0, 0.4, 1.3, 2.2, 3.0, kPi}) {
                        rows.push_back(makeShadingPoint(n, turned(n, directionAt(NoV, 0.2)),
                                                        turned(n, directionAt(NoL, 0.2 + azimuth)), r));
                        giveMaterial(rows.back(), random);
                    }
    for (int i = 0; i < 20000; ++i) {
        const double r = random.uniform(0.01, 1.0);
        const dvec3 n = random.direction();
        const dvec3 v = turned(n, directionAt(random.uniform(0.001, 1.0), random.uniform(0, 2 * kPi)));
        dvec3 l = turned(n, directionAt(random.uniform(0.001, 1.0), random.uniform(0, 2 * kPi)));
        if (i % 2 == 0) {
            const double tangent = r * r * random.uniform(0.0, 4.0);
            const dvec3 h = turned(n, directionAt(1 / std::sqrt(1 + tangent * tangent), random.uniform(0, 2 * kPi)));
            l = 2 * glm::dot(v, h) * h - v;
        }
        rows.push_back(makeShadingPoint(n, v, l, r));
        giveMaterial(rows.back(), random);
    }
    return rows;
}

std::vector<ShadingPoint> probeCorners()
{
    std::vector<ShadingPoint> rows;
    for (const double NoV : {-0.3, 0.0, 1e-38, 1e-20, 1e-6, 1.0})
        for (const double NoL : {-1.0, 0.0, 1e-38, 1e-20, 1e-6, 1.0})
            for (const double NoH : {0.0, 1e-20, 1e-3, 1.0})
                for (const double VoH : {0.0, 1e-20, 1e-3, 0.5, 1.0})
                    for (const double r : {0.0, 0.005, 0.01, 0.5, 1.0}) {
                        ShadingPoint p = makeShadingPoint(dvec3(0, 0, 1), dvec3(0, 0, 1), dvec3(0, 0, 1), r);
                        p.NoV = NoV;
                        p.NoL = NoL;
                        p.NoH = NoH;
                        p.VoH = std::max(VoH, 0.5 * (NoV + NoL)); // n.(v + l) <= |v + l| = 2 VoH
                        p.oneLessVoH = 1 - p.VoH;
                        p.VoL = 2 * p.VoH * p.VoH - 1;
                        p.sin2H = 1 - NoH * NoH;
                        p.ToH = std::sqrt(p.sin2H);
                        p.BoH = 0;
                        for (const double index : {0.0, 0.5, 1.0, 1.5, 1e6}) {
                            p.ior = index;
                            p.eta = dvec3(index, index, 1.0);
                            p.k = dvec3(0.0, 1e6, 1e-30);
                            rows.push_back(p);
                        }
                    }
    return rows;
}

std::string describe(const ShadingPoint& p)
{
    std::ostringstream text;
    text << std::setprecision(9) << "NoV=" << p.NoV << " NoL=" << p.NoL << " NoH=" << p.NoH << " VoH=" << p.VoH
         << " VoL=" << p.VoL << " sin2H=" << p.sin2H << " r=" << p.perceptualRoughness << " ior=" << p.ior
         << " eta=" << p.eta.x << " k=" << p.k.x << " metallic=" << p.metallic;
    return text.str();
}

} // namespace torrance
