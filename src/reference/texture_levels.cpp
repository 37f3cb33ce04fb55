#include "reference/texture_levels.h"

#include "brdf/texture_filter.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace torrance {
namespace {

int levelCount(const TextureImage& image)
{
    return std::bit_width(static_cast<unsigned>(std::max(image.width, image.height)));
}

int sideOf(int side, int level)
{
    return std::max(1, side >> level);
}

/// The part of an axis of `fine` texels under texel i of `coarse`, in fine texels.
struct Span
{
    double first, last;

    Span(int i, int fine, int coarse) : first(double(i) * fine / coarse), last(double(i + 1) * fine / coarse) {}

    int begin() const { return static_cast<int>(std::floor(first)); }
    int end() const { return static_cast<int>(std::ceil(last)); }
    /// How much of fine texel k lies in it.
    double share(int k) const { return std::min(last, k + 1.0) - std::max(first, double(k)); }
};

dvec4 unitNormal(const dvec4& code)
{
    const dvec3 n = 2.0 * dvec3(code) - 1.0;
    const double length = glm::length(n);
    return dvec4(length > 0.0 ? n / length : dvec3(0.0), code.a);
}

dvec4 normalCode(const dvec4& mean)
{
    const double length = glm::length(dvec3(mean));
    return dvec4(0.5 * (length > 0.0 ? dvec3(mean) / length : dvec3(0.0, 0.0, 1.0)) + 0.5, mean.a);
}

/// Sum over the area of what `value` gives for each texel, over the area.
template <typename Value>
dvec4 meanOver(const Span& columns, const Span& rows, const Value& value)
{
    dvec4 sum(0.0);
    for (int y = rows.begin(); y < rows.end(); ++y)
        for (int x = columns.begin(); x < columns.end(); ++x)
            sum += columns.share(x) * rows.share(y) * value(x, y);
    return sum / ((columns.last - columns.first) * (rows.last - rows.first));
}

long long texelFloor(double u)
{
    constexpr double kExact = 4503599627370496.0; // 2^52: beyond it there is no fraction left
    return static_cast<long long>(std::floor(std::clamp(u, -kExact, kExact)));
}

dvec4 sampleLevel(const TextureImage& image, const Sampler& sampler, const LevelRule& rule, Filter filter,
                  const dvec2& uv, int level)
{
    const int width = sideOf(image.width, level), height = sideOf(image.height, level);
    const auto texel = [&](long long x, long long y) {
        return levelTexel(image, rule, level, wrapIndex(x, width, sampler.wrapS), wrapIndex(y, height, sampler.wrapT));
    };
    const dvec2 place = uv * dvec2(width, height);
    if (filter == Filter::nearest)
        return texel(texelFloor(place.x), texelFloor(place.y));
    const long long x = texelFloor(place.x - 0.5), y = texelFloor(place.y - 0.5);
    const dvec2 f = place - 0.5 - dvec2(double(x), double(y));
    return (1.0 - f.y) * ((1.0 - f.x) * texel(x, y) + f.x * texel(x + 1, y)) +
           f.y * ((1.0 - f.x) * texel(x, y + 1) + f.x * texel(x + 1, y + 1));
}

dvec2 inTexels(const dvec2& step, const TextureImage& image)
{
    const dvec2 texels = step * dvec2(image.width, image.height);
    return std::isfinite(glm::length(texels)) ? texels : dvec2(0.0);
}

} // namespace

dvec4 levelTexel(const TextureImage& image, const LevelRule& rule, int level, int x, int y)
{
    const ColorSpace space = rule.content == TexelContent::color ? ColorSpace::srgb : ColorSpace::linear;
    if (level == 0)
        return texelAt(image, x, y, space);
    const Span columns(x, image.width, sideOf(image.width, level)), rows(y, image.height, sideOf(image.height, level));
    if (rule.content == TexelContent::normal)
        return normalCode(
            meanOver(columns, rows, [&](int i, int k) { return unitNormal(texelAt(image, i, k, space)); }));
    if (!rule.weighByAlpha)
        return meanOver(columns, rows, [&](int i, int k) { return texelAt(image, i, k, space); });
    const dvec4 mean = meanOver(columns, rows, [&](int i, int k) {
        const dvec4 texel = texelAt(image, i, k, space);
        return dvec4(dvec3(texel) * texel.a, texel.a);
    });
    return mean.a > 0.0 ? dvec4(dvec3(mean) / mean.a, mean.a) : dvec4(0.0);
}

double levelOfDetail(const TextureImage& image, const UvSteps& steps, double bias)
{
    return brdf::T_trilinear_exact({inTexels(steps.right, image), inTexels(steps.below, image)}) + bias;
}

dvec4 sampleLevels(const TextureImage& image, const Sampler& sampler, const LevelRule& rule, const dvec2& uv,
                   double levelOfDetail)
{
    const dvec2 finite(std::isfinite(uv.x) ? uv.x : 0.0, std::isfinite(uv.y) ? uv.y : 0.0);
    if (!(levelOfDetail > 0.0))
        return sampleLevel(image, sampler, rule, sampler.magnify, finite, 0);
    const double last = levelCount(image) - 1.0;
    const double level = std::min(levelOfDetail, last);
    if (sampler.mip == MipFilter::none)
        return sampleLevel(image, sampler, rule, sampler.minify, finite, 0);
    if (sampler.mip == MipFilter::nearest) // halfway, the finer one
        return sampleLevel(image, sampler, rule, sampler.minify, finite, static_cast<int>(std::ceil(level - 0.5)));
    const int finer = static_cast<int>(level), coarser = std::min(finer + 1, static_cast<int>(last));
    const double f = level - finer;
    const dvec4 fine = sampleLevel(image, sampler, rule, sampler.minify, finite, finer);
    return f > 0.0 ? (1.0 - f) * fine + f * sampleLevel(image, sampler, rule, sampler.minify, finite, coarser) : fine;
}

} // namespace torrance
