#include "study/rounded_point.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

using gpu::Precision;

struct Format
{
    int bits;          // of the mantissa, the hidden one included
    int leastExponent; // of a normal number
};

Format formatOf(Precision precision)
{
    switch (precision) {
    case Precision::fp16:
        return {11, -14};
    case Precision::fp32:
        return {24, -126};
    default:
        return {53, -1022};
    }
}

// Of the last place of x.
double unitAt(double x, Precision precision)
{
    const Format format = formatOf(precision);
    const int exponent = x == 0 ? format.leastExponent : std::max(std::ilogb(x), format.leastExponent);
    return std::ldexp(1.0, exponent - format.bits + 1);
}

dvec3 roundedTo(const dvec3& x, Precision precision)
{
    return {torrance::roundedTo(x.x, precision), torrance::roundedTo(x.y, precision),
            torrance::roundedTo(x.z, precision)};
}

// 0 stays: it is met where vectors coincide, and then it is exact.
double moved(double x, Precision precision, int units)
{
    const double rounded = torrance::roundedTo(x, precision);
    return rounded == 0 ? 0.0 : rounded + units * unitAt(rounded, precision);
}

} // namespace

double unitRoundoff(Precision precision)
{
    return std::ldexp(1.0, -formatOf(precision).bits);
}

double leastNormal(Precision precision)
{
    return std::ldexp(1.0, formatOf(precision).leastExponent);
}

double roundedTo(double x, Precision precision)
{
    const double unit = unitAt(x, precision);
    return std::nearbyint(x / unit) * unit; // both by a power of two: exact
}

brdf::ShadingPoint materialRounded(brdf::ShadingPoint point, Precision precision)
{
    point.perceptualRoughness = roundedTo(point.perceptualRoughness, precision);
    for (dvec3* color : {&point.f0, &point.f90, &point.eta, &point.k, &point.f82, &point.baseColor, &point.single,
                         &point.spread, &point.F, &point.FNoV, &point.FNoL, &point.lobeAlbedo})
        *color = roundedTo(*color, precision);
    for (double* scalar : {&point.ior, &point.metallic, &point.E, &point.bias, &point.ELight, &point.EAverage})
        *scalar = roundedTo(*scalar, precision);
    point.alpha = std::max(point.perceptualRoughness * point.perceptualRoughness, brdf::kMinAlpha);
    point.alphaT = point.alpha;
    point.alphaB = point.alpha;
    return point;
}

brdf::ShadingPoint geometryRounded(brdf::ShadingPoint point, Precision precision, int units)
{
    for (double* cosine : {&point.NoV, &point.NoL, &point.VoL, &point.NoH, &point.VoH})
        *cosine = std::clamp(moved(*cosine, precision, units), -1.0, 1.0);
    for (double* share : {&point.sin2H, &point.oneLessVoH})
        *share = std::clamp(moved(*share, precision, units), 0.0, 1.0);
    return point;
}

} // namespace torrance
