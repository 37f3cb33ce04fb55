#include "brdf/lobe_albedo.h"

#include "brdf/distribution.h"
#include "brdf/fresnel.h"
#include "brdf/visibility.h"
#include "math/quadrature.h"

#include <algorithm>
#include <array>

namespace torrance::brdf {
namespace {

struct Kept
{
    double NoV = -1, perceptualRoughness = -1;
    AlbedoTerms terms;
};

// E turns within NoV ~ alpha: the root spreads that over the nodes.
double lostOnAverage(double perceptualRoughness)
{
    static const QuadratureRule roots = gaussLegendre(16, 0.0, 1.0);
    return integrate(roots, [&](double root) {
        return 4.0 * root * root * root * (1.0 - ggxAlbedo(root * root, perceptualRoughness).albedo());
    });
}

dvec3 schlickAt(ShadingPoint point, double cosine)
{
    point.VoH = cosine;
    point.oneLessVoH = 1.0 - cosine;
    return F_schlick(point);
}

} // namespace

AlbedoTerms lobeTerms(double NoV, double perceptualRoughness)
{
    thread_local std::array<Kept, 2> kept; // the newer first
    const auto matches = [&](const Kept& k) { return k.NoV == NoV && k.perceptualRoughness == perceptualRoughness; };
    if (!matches(kept[0])) {
        std::swap(kept[0], kept[1]);
        if (!matches(kept[0]))
            kept[0] = {NoV, perceptualRoughness, ggxAlbedo(NoV, perceptualRoughness)};
    }
    return kept[0].terms;
}

double averageLobeAlbedo(double perceptualRoughness)
{
    thread_local double lastRoughness = -1, average = 1;
    if (perceptualRoughness != lastRoughness) {
        average = 1.0 - lostOnAverage(perceptualRoughness);
        lastRoughness = perceptualRoughness;
    }
    return average;
}

void setLobeAlbedo(ShadingPoint& point)
{
    const AlbedoTerms view = lobeTerms(std::clamp(point.NoV, 0.0, 1.0), point.perceptualRoughness);
    point.E = view.albedo();
    point.bias = view.bias;
    point.ELight = lobeTerms(std::clamp(point.NoL, 0.0, 1.0), point.perceptualRoughness).albedo();
    point.EAverage = averageLobeAlbedo(point.perceptualRoughness);
}

void setInterface(ShadingPoint& point)
{
    setLobeAlbedo(point);
    point.F = F_schlick(point);
    point.FNoV = schlickAt(point, std::clamp(point.NoV, 0.0, 1.0));
    point.FNoL = schlickAt(point, std::clamp(point.NoL, 0.0, 1.0));
    point.lobeAlbedo = point.f0 * (point.E - point.bias) + point.bias;
    point.single = D_ggx(point) * V_smith_corr(point) * point.F;
}

} // namespace torrance::brdf
