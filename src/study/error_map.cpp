#include "study/error_map.h"

#include "measure/heat_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

constexpr double kDecades = 8.0; // from 1e-8 to 1
constexpr int kMapSide = 256;    // pixels, or the least multiple of the cells that reaches it
constexpr int kGap = 8;
constexpr int kBar = 16;
constexpr float kNotFinite[] = {0.1f, 0.6f, 1.0f};
constexpr float kPage = 1.0f; // white between map and bar

float brightness(double error)
{
    return error > 0 ? static_cast<float>((std::log10(error) + kDecades) / kDecades) : 0.0f;
}

void fill(Image& image, int x, int y, const float* color)
{
    std::copy_n(color, 3, image.at(x, y));
}

} // namespace

Image errorMap(std::span<const double> errors, const SweepAxes& axes)
{
    const int columns = static_cast<int>(axes.cosines.size()), rows = static_cast<int>(axes.rows.size());
    assert(errors.size() == axes.cosines.size() * axes.rows.size());
    const int side = (kMapSide + columns - 1) / columns;
    const int width = side * columns, height = side * rows;

    Image values(columns, rows, 1);
    std::ranges::transform(errors, values.texels.begin(), brightness);
    const Image colors = heatMap(values);
    Image bar(1, height, 1);
    for (int y = 0; y < height; ++y)
        *bar.at(0, y) = 1.0f - static_cast<float>(y) / static_cast<float>(height - 1);
    const Image barColors = heatMap(bar);

    Image picture(width + kGap + kBar, height, 3, kPage);
    for (int y = 0; y < height; ++y) {
        const int row = rows - 1 - y / side;
        for (int x = 0; x < width; ++x) {
            const double error =
                errors[static_cast<std::size_t>(row) * axes.cosines.size() + static_cast<std::size_t>(x / side)];
            fill(picture, x, y, std::isfinite(error) ? colors.at(x / side, row) : kNotFinite);
        }
        for (int x = 0; x < kBar; ++x)
            fill(picture, width + kGap + x, y, barColors.at(0, y));
    }
    return picture;
}

std::string errorMapLegend(brdf::Slot slot, const SweepAxes& axes)
{
    const AxisNames names = axisNames(slot);
    const std::string rows = slot == brdf::Slot::fresnel
                                 ? fmt::format("{} {:.3g} (bottom) over 1 - 1e-6, 1 and 1 + 1e-6 to {:.3g} (top), "
                                               "logarithmic on both sides of 1",
                                               names.row, axes.rows.front(), axes.rows.back())
                                 : fmt::format("{} {:.3g} (bottom) to {:.3g} (top), spaced by squares", names.row,
                                               axes.rows.front(), axes.rows.back());
    return fmt::format("Across: {} {:.3g} (left) to {:.3g} (right), spaced by squares. Up: {}. Colour: log10 of the "
                       "greatest error of a cell, from 1e-8 and less (black, foot of the bar) to 1 and more (pale "
                       "yellow, its top), a decade per eighth of the bar; blue: not finite.",
                       names.cosine, axes.cosines.front(), axes.cosines.back(), rows);
}

} // namespace torrance
