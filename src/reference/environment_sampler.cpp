#include "reference/environment_sampler.h"

#include "math/guided_choice.h"
#include "math/latlong.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

/// Rotation about +Y, counter-clockwise seen from above.
dmat3 turned(double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {dvec3(c, 0.0, -s), dvec3(0.0, 1.0, 0.0), dvec3(s, 0.0, c)};
}

/// A point of [-1, 1] of density 1 - |x|.
double triangular(double u)
{
    return u < 0.5 ? std::sqrt(2.0 * u) - 1.0 : 1.0 - std::sqrt(2.0 * (1.0 - u));
}

} // namespace

EnvironmentSampler::EnvironmentSampler(const Environment& environment)
    : width(environment.radiance.width), height(environment.radiance.height), intensity(environment.intensity),
      worldFromEnvironment(turned(environment.rotation))
{
    texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    columns.resize(texels.size());
    for (int y = 0; y < height; ++y) {
        const double sine = std::sin(kPi * (y + 0.5) / height);
        double row = 0.0;
        for (int x = 0; x < width; ++x) {
            const float* rgb = environment.radiance.at(x, y);
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
            const double luminance = (double(rgb[0]) + double(rgb[1]) + double(rgb[2])) / 3.0;
            texels[i] = {rgb[0], rgb[1], rgb[2], static_cast<float>(luminance * sine)};
            row += static_cast<double>(texels[i].weight);
            columns[i] = row;
        }
        total += row;
        rows.push_back(total);
    }
    rowGuide.resize(rows.size());
    makeGuide(rows, rowGuide);
    columnGuides.resize(columns.size());
    const auto stride = static_cast<std::size_t>(width);
    for (std::size_t first = 0; first < columns.size(); first += stride)
        makeGuide(std::span(columns).subspan(first, stride), std::span(columnGuides).subspan(first, stride));
    if (!(intensity > 0.0))
        total = 0.0;
}

DirectedLight EnvironmentSampler::at(const dvec3& direction) const
{
    const dvec3 local = direction * worldFromEnvironment; // times the transpose: the inverse of a rotation
    const dvec2 place = latLongFromDirection(local) * dvec2(width, height) - 0.5;
    const double column = std::floor(place.x), row = std::floor(place.y);
    const double fx = place.x - column, fy = place.y - row;
    const int x0 = (static_cast<int>(column) + width) % width, x1 = x0 + 1 == width ? 0 : x0 + 1;
    const int y0 = std::clamp(static_cast<int>(row), 0, height - 1),
              y1 = std::min(static_cast<int>(row) + 1, height - 1);
    const Texel &a = texel(x0, y0), &b = texel(x1, y0), &c = texel(x0, y1), &d = texel(x1, y1);
    const auto blend = [&](float p, float q, float r, float s) {
        return (1.0 - fy) * ((1.0 - fx) * double(p) + fx * double(q)) + fy * ((1.0 - fx) * double(r) + fx * double(s));
    };
    const double sine = std::sqrt(local.x * local.x + local.z * local.z);
    DirectedLight light;
    light.radiance = intensity * dvec3(blend(a.r, b.r, c.r, d.r), blend(a.g, b.g, c.g, d.g), blend(a.b, b.b, c.b, d.b));
    const double weight = blend(a.weight, b.weight, c.weight, d.weight);
    if (weight > 0.0) // solid angle = 2 pi^2 sin(theta) du dv
        light.density = weight * double(width) * double(height) / (total * 2.0 * kPi * kPi * sine);
    return light;
}

dvec3 EnvironmentSampler::draw(const dvec2& u) const
{
    const auto stride = static_cast<std::size_t>(width);
    const IntervalChoice row = choose(rows, rowGuide, u.y);
    const std::size_t first = row.index * stride;
    const IntervalChoice column =
        choose(std::span(columns).subspan(first, stride), std::span(columnGuides).subspan(first, stride), u.x);
    const double x = (static_cast<double>(column.index) + 0.5 + triangular(column.rest)) / width;
    double y = (static_cast<double>(row.index) + 0.5 + triangular(row.rest)) / height;
    y = y < 0.0 ? -y : y > 1.0 ? 2.0 - y : y;
    return worldFromEnvironment * directionFromLatLong({x, y});
}

} // namespace torrance
