#include "brdf/condition.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

constexpr double kStep = 0x1p-24;

struct Geometry
{
    dvec3 n, v, l;
    double perceptualRoughness;
};

ShadingPoint pointFrom(const Geometry& geometry, const ShadingPoint& rest)
{
    ShadingPoint point = makeShadingPoint(geometry.n, geometry.v, geometry.l, geometry.perceptualRoughness);
    setAnisotropy(point, rest.tangent, rest.anisotropy);
    point.f0 = rest.f0;
    point.f90 = rest.f90;
    point.ior = rest.ior;
    point.eta = rest.eta;
    point.k = rest.k;
    point.f82 = rest.f82;
    point.baseColor = rest.baseColor;
    point.metallic = rest.metallic;
    point.E = rest.E;
    point.bias = rest.bias;
    point.ELight = rest.ELight;
    point.EAverage = rest.EAverage;
    point.single = rest.single;
    point.spread = rest.spread;
    point.F = rest.F;
    point.FNoV = rest.FNoV;
    point.FNoL = rest.FNoL;
    point.lobeAlbedo = rest.lobeAlbedo;
    return point;
}

} // namespace

double conditionNumber(const std::function<dvec3(const ShadingPoint&)>& formula, const ShadingPoint& at)
{
    Geometry moved = {at.n, at.v, at.l, at.perceptualRoughness};
    const auto value = [&] { return formula(pointFrom(moved, at)); };
    const dvec3 center = value();
    double* const inputs[] = {&moved.n.x, &moved.n.y, &moved.n.z, &moved.v.x, &moved.v.y,
                              &moved.v.z, &moved.l.x, &moved.l.y, &moved.l.z, &moved.perceptualRoughness};
    dvec3 kappa(0);
    for (double* const input : inputs) {
        const double x = *input;
        if (x == 0)
            continue; // has no rounding
        *input = x * (1 + kStep);
        const dvec3 above = value();
        *input = x * (1 - kStep);
        const dvec3 below = value();
        *input = x;
        for (int channel = 0; channel < 3; ++channel)
            if (center[channel] != 0)
                kappa[channel] +=
                    std::max(std::abs(above[channel] - center[channel]), std::abs(below[channel] - center[channel])) /
                    (kStep * std::abs(center[channel]));
    }
    return std::max({kappa.r, kappa.g, kappa.b});
}

} // namespace torrance::brdf
