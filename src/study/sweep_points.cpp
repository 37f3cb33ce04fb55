#include "study/sweep_points.h"

#include "brdf/fresnel.h"
#include "brdf/lobe_albedo.h"
#include "study/rounded_point.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

using brdf::ShadingPoint;
using brdf::Slot;

constexpr double kLeastCosine = 1e-4; // kMinNoV of shaders/shared/constants.h

std::vector<double> squares(int count, double least)
{
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        const double x = static_cast<double>(i) / (count - 1);
        values.push_back(std::max(least, x * x));
    }
    return values;
}

// A third below 1, at 1 - 0.6 ... 1 - 1e-6, one at 1, the rest at 1 + 1e-6 ... 1 + 2.
std::vector<double> indices(int count)
{
    const auto offset = [](double place, double greatest) { return std::pow(greatest / 1e-6, place) * 1e-6; };
    const int below = count / 3, above = count - below - 1;
    std::vector<double> values;
    for (int i = 0; i < below; ++i)
        values.push_back(1 - offset(1 - i / (below - 1.0), 0.6));
    values.push_back(1);
    for (int i = 0; i < above; ++i)
        values.push_back(1 + offset(i / (above - 1.0), 2.0));
    return values;
}

dvec3 directionAt(double cosine, double azimuth)
{
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

constexpr dvec3 kNormal = dvec3(0, 0, 1);
constexpr double kAzimuths[] = {0.0, 1.3, kPi};

// h by its angle from n.
void addHalfVectors(std::vector<ShadingPoint>& points, double NoV, double r, std::span<const double> angles)
{
    const dvec3 v = directionAt(NoV, 0);
    for (const double angle : angles)
        for (const double azimuth : kAzimuths) {
            const dvec3 h = {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
            const dvec3 l = 2 * glm::dot(v, h) * h - v;
            if (l.z > 0 && glm::dot(v, h) > 0 && (angle > 0 || azimuth == 0))
                points.push_back(brdf::makeShadingPoint(kNormal, v, l, r));
        }
}

std::vector<double> anglesOf(double r)
{
    std::vector<double> angles = {0.0, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.4, 0.8};
    const double alpha = std::max(r * r, brdf::kMinAlpha);
    for (const double widths : {0.1, 0.5, 1.0, 2.0, 5.0})
        angles.push_back(std::atan(widths * alpha));
    return angles;
}

void addLights(std::vector<ShadingPoint>& points, double NoV, double r)
{
    for (const double NoL : {kLeastCosine, 1e-2, 0.1, 0.5, 0.9, 1.0})
        for (const double azimuth : kAzimuths)
            points.push_back(brdf::makeShadingPoint(kNormal, directionAt(NoV, 0), directionAt(NoL, azimuth), r));
}

// Of a dielectric whose index is real, and of metals: gold-like, one with an index below 1, one near vacuum.
ShadingPoint fresnelPoint(double VoH, double ior)
{
    ShadingPoint point = brdf::makeShadingPoint(kNormal, directionAt(VoH, 0), directionAt(VoH, kPi), 0.5);
    point.ior = ior;
    return point;
}

std::vector<ShadingPoint> fresnelPoints(double VoH, double ior)
{
    ShadingPoint dielectric = fresnelPoint(VoH, ior), metal = dielectric;
    dielectric.f0 = dvec3((ior - 1) / (ior + 1) * ((ior - 1) / (ior + 1)));
    dielectric.eta = dvec3(ior);
    metal.eta = {0.18, ior, 2.9};
    metal.k = {3.4, 2.0, 3.0};
    const auto square = [](const dvec3& x) { return x * x; };
    metal.f0 = (square(metal.eta - 1.0) + square(metal.k)) / (square(metal.eta + 1.0) + square(metal.k));
    ShadingPoint at82 = fresnelPoint(1.0 / 7.0, ior);
    at82.eta = metal.eta;
    at82.k = metal.k;
    at82.f0 = metal.f0;
    metal.f82 = brdf::F_exact_conductor(at82) / brdf::F_schlick(at82);
    return {dielectric, metal};
}

std::vector<ShadingPoint> pointsAt(Slot slot, double cosine, double row)
{
    std::vector<ShadingPoint> points;
    switch (slot) {
    case Slot::fresnel:
        return fresnelPoints(cosine, row);
    case Slot::distribution:
        addHalfVectors(points, cosine, row, anglesOf(row));
        return points;
    case Slot::dfg:
        return {mirrorPoint(cosine, row)};
    case Slot::multipleScattering:
    case Slot::diffuseWeight: // an integral per direction of light: two of them
        return {mirrorPoint(cosine, row),
                brdf::makeShadingPoint(kNormal, directionAt(cosine, 0), directionAt(0.3, 1.3), row)};
    default:
        addLights(points, cosine, row);
        addHalfVectors(points, cosine, row, std::vector{0.0, 1e-3, 0.1, 0.8});
        return points;
    }
}

} // namespace

bool readsInterface(Slot slot)
{
    return slot == Slot::multipleScattering || slot == Slot::diffuseWeight;
}

AxisNames axisNames(Slot slot)
{
    return slot == Slot::fresnel ? AxisNames{"VoH", "ior"} : AxisNames{"NoV", "roughness"};
}

SweepAxes sweepAxes(Slot slot, int size)
{
    return {.cosines = squares(size, kLeastCosine),
            .rows = slot == Slot::fresnel ? indices(size) : squares(size, 0.0),
            .leastLight = 0.0};
}

ShadingPoint mirrorPoint(double NoV, double perceptualRoughness)
{
    return brdf::makeShadingPoint(kNormal, directionAt(NoV, 0), directionAt(NoV, kPi), perceptualRoughness);
}

std::vector<ShadingPoint> sweepPoints(Slot slot, double cosine, double row, gpu::Precision precision)
{
    const double given = roundedTo(row, precision);
    std::vector<ShadingPoint> points = pointsAt(slot, cosine, given);
    for (ShadingPoint& point : points) {
        if (slot != Slot::fresnel)
            point.f0 = dvec3(0.04, 0.5, 1.0);
        point.baseColor = dvec3(0.03, 0.5, 1.0);
        if (readsInterface(slot))
            brdf::setInterface(point);
        point = materialRounded(point, precision);
    }
    return points;
}

} // namespace torrance
