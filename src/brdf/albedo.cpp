#include "brdf/albedo.h"

#include "brdf/shading_point.h"
#include "math/vector.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace torrance::brdf {
namespace {

/// Nodes of the tanh-sinh rule on [0, 1] (Takahasi & Mori 1974). They crowd at both ends, where the integrands below
/// have layers as thin as alpha and weak singularities.
struct DoubleExponential
{
    struct Node
    {
        double fromLow;  // x
        double fromHigh; // 1 - x, kept apart so that it does not cancel
        double weight;
    };
    std::vector<Node> nodes;

    DoubleExponential(double step, double reach)
    {
        const int count = static_cast<int>(std::ceil(reach / step));
        for (int i = -count; i <= count; ++i) {
            const double u = 0.5 * kPi * std::sinh(i * step);
            const double low = 1.0 / (1.0 + std::exp(-2.0 * u)), high = 1.0 / (1.0 + std::exp(2.0 * u));
            nodes.push_back({low, high, step * kPi * std::cosh(i * step) * low * high});
        }
    }
};

constexpr double kStep =
    1.0 / 7.0;                 // a step of 1/24 changes either term of ggxAlbedo by less than 2e-7 of E, and w by 1e-11
constexpr double kReach = 3.0; // there the nodes are 2e-14 from the ends

const DoubleExponential& rule()
{
    static const DoubleExponential nodes(kStep, kReach);
    return nodes;
}

/// Integral of f over [from, to]; f is given the point.
template <typename Function>
double integrate(double from, double to, const Function& f)
{
    double sum = 0.0;
    for (const DoubleExponential::Node& node : rule().nodes)
        sum += node.weight * f(from * node.fromHigh + to * node.fromLow);
    return sum * (to - from);
}

/// The reflected directions in the space where a GGX surface is a hemisphere (Dupuy & Benyoub 2023): there they fill
/// evenly the cap of unit vectors c with c.z > -i.z, i the stretched view direction. A point of the cap is given by p =
/// i.z + c.z and the azimuth phi about z, measured from i.
struct StretchedCap
{
    double alpha;
    double NoV;
    double k;      // length of the stretched view direction = sqrt(alpha^2 + (1 - alpha^2) NoV^2)
    double ix, iz; // i = (ix, 0, iz)

    StretchedCap(double cosine, double roughness)
        : alpha(roughness), NoV(cosine),
          k(std::sqrt(roughness * roughness * (1.0 - cosine * cosine) + cosine * cosine)),
          ix(roughness * std::sqrt(1.0 - cosine * cosine) / k), iz(cosine / k)
    {
    }

    double ring(double p) const { return std::sqrt(std::max(0.0, (1.0 - p + iz) * (1.0 + p - iz))); } // |(c.x, c.y)|

    /// q = |i + c|^2 / 2, as a sum of squares.
    double q(double p, double cosPhi) const
    {
        const double r = ring(p);
        return 0.5 * (ix * ix + r * r + p * p) + ix * r * cosPhi;
    }

    /// The light is above the surface where q > horizon(p); nowhere for p <= alpha^2 i.z.
    double horizon(double p) const
    {
        const double above = p - iz * alpha * alpha;
        return above > 0.0 ? 0.5 * iz * (1.0 - alpha * alpha) * p * p / above : HUGE_VAL;
    }

    double lastAzimuth(double p) const
    {
        const double nearest = q(p, 1.0), farthest = q(p, -1.0), limit = horizon(p);
        if (limit <= farthest)
            return kPi;
        if (limit >= nearest)
            return 0.0;
        return std::acos(std::clamp((2.0 * limit - nearest - farthest) / (nearest - farthest), -1.0, 1.0));
    }

    struct Reflection
    {
        double NoL; // not above 0 below the horizon
        double VoH;
    };

    Reflection reflect(double p, double cosPhi) const
    {
        const double a2 = alpha * alpha;
        const double Q = q(p, cosPhi);
        const double h2 = a2 * (2.0 * Q - p * p) + p * p; // squared length of the unstretched half vector
        const double NoL = k * (2.0 * Q * (p - iz * a2) - iz * (1.0 - a2) * p * p) / h2;
        return {NoL, std::min(1.0, k * Q / std::sqrt(h2))};
    }
};

/// The p in [low, high] at which `inside` turns from false to true; it is true at high.
template <typename Predicate>
double turningPoint(double low, double high, const Predicate& inside)
{
    if (inside(low))
        return low;
    for (int i = 0; i < 60 && high - low > 1e-15 * high; ++i) {
        const double middle = 0.5 * (low + high);
        (inside(middle) ? high : low) = middle;
    }
    return high;
}

double pow5(double x)
{
    return x * x * x * x * x;
}

StretchedCap capOf(double NoV, double perceptualRoughness)
{
    return {std::clamp(NoV, 0.0, 1.0), std::max(perceptualRoughness * perceptualRoughness, kMinAlpha)};
}

/// Both terms; `share` is what a direction of light at NoL > 0 counts of the visible facets' light: 2 V NoL (NoV + k).
template <typename Share>
AlbedoTerms albedoOver(const StretchedCap& cap, const Share& share)
{
    const double top = 1.0 + cap.iz;
    AlbedoTerms sum;
    const auto band = [&](double p, double pWeight) {
        const double last = cap.lastAzimuth(p);
        for (const DoubleExponential::Node& node : rule().nodes) {
            const StretchedCap::Reflection r = cap.reflect(p, std::cos(last * node.fromLow));
            if (!(r.NoL > 0.0)) // rounding on the horizon, where the share vanishes
                continue;
            const double light = pWeight * node.weight * last * share(r.NoL);
            const double fresnel = pow5(1.0 - r.VoH);
            sum.scale += light * (1.0 - fresnel);
            sum.bias += light * fresnel;
        }
    };
    // Between the first ring that has any light and the first that has light all around, the azimuth's limit moves.
    const double first = turningPoint(0.0, top, [&](double p) { return cap.horizon(p) < cap.q(p, 1.0); });
    const double whole = turningPoint(first, top, [&](double p) { return cap.horizon(p) <= cap.q(p, -1.0); });
    for (const auto& [from, to] : {std::pair(first, whole), std::pair(whole, top)})
        for (const DoubleExponential::Node& node : rule().nodes)
            band(from * node.fromHigh + to * node.fromLow, node.weight * (to - from));
    const double area = kPi * top; // half of the cap: the other half mirrors it
    return {sum.scale / area, sum.bias / area};
}

} // namespace

AlbedoTerms ggxAlbedo(double NoV, double perceptualRoughness)
{
    const StretchedCap cap = capOf(NoV, perceptualRoughness);
    const double a2 = cap.alpha * cap.alpha;
    // Heitz 2014, eq. 99 over eq. 43: G2 / G1 = (1 + Lambda(v)) / (1 + Lambda(v) + Lambda(l))
    return albedoOver(cap, [&](double NoL) {
        return NoL * (cap.NoV + cap.k) / (NoL * cap.k + cap.NoV * std::sqrt(a2 + (1.0 - a2) * NoL * NoL));
    });
}

AlbedoTerms ggxAlbedo(double NoV, double perceptualRoughness, const std::function<double(double NoL)>& visibility)
{
    const StretchedCap cap = capOf(NoV, perceptualRoughness);
    return albedoOver(cap, [&](double NoL) { return 2.0 * visibility(NoL) * NoL * (cap.NoV + cap.k); });
}

double schlickDiffuseWeight(double NoV)
{
    const double cosine = std::clamp(NoV, 0.0, 1.0);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    // Rings of directions l at the angle gamma from v: the cosine NoL = A + B cos psi is integrated over psi in closed
    // form.
    const auto ring = [&](double gamma) {
        const double A = cosine * std::cos(gamma), B = sine * std::sin(gamma);
        const double psi = B > std::abs(A) ? std::acos(-A / B) : (A > 0.0 ? kPi : 0.0);
        return pow5(1.0 - std::cos(0.5 * gamma)) * std::sin(gamma) * 2.0 * (A * psi + B * std::sin(psi));
    };
    const double theta = std::atan2(sine, cosine);
    const double whole = 0.5 * kPi - theta; // rings up to here lie above the horizon
    return (integrate(0.0, whole, ring) + integrate(whole, 0.5 * kPi + theta, ring)) / kPi;
}

} // namespace torrance::brdf
