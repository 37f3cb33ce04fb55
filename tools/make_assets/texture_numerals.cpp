#include "make_assets/textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace torrance::assets {
namespace {

/// The seven strokes of a digit that is 1 wide and 2 high, (0, 0) at its upper left.
constexpr std::array<std::array<dvec2, 2>, 7> kStrokes = {{
    {dvec2(0, 0), dvec2(1, 0)},
    {dvec2(1, 0), dvec2(1, 1)},
    {dvec2(1, 1), dvec2(1, 2)},
    {dvec2(0, 2), dvec2(1, 2)},
    {dvec2(0, 1), dvec2(0, 2)},
    {dvec2(0, 0), dvec2(0, 1)},
    {dvec2(0, 1), dvec2(1, 1)},
}};

/// Which strokes light up, first stroke first.
std::string_view litStrokes(char digit)
{
    switch (digit) {
    case '1':
        return "0110000";
    case '9':
        return "1111011";
    case '6':
        return "1011111";
    default:
        return "1110000"; // 7
    }
}

/// Distance to a stroke, which is a little shorter than its line so that strokes stand apart.
double strokeDistance(const dvec2& place, const std::array<dvec2, 2>& line)
{
    const dvec2 direction = glm::normalize(line[1] - line[0]);
    const double t = std::clamp(glm::dot(place - line[0], direction), 0.14, 0.86);
    return glm::length(place - line[0] - direction * t);
}

} // namespace

Image numerals(int height)
{
    return makePicture(2 * height, height, 3, [height](double u, double v) {
        constexpr std::string_view kYear = "1967";
        constexpr double kDigitsAcross = 7.4; // digit widths in the picture's width
        double light = 0.0;
        for (std::size_t i = 0; i < kYear.size(); ++i) {
            dvec2 place(u * kDigitsAcross, v * kDigitsAcross / 2.0);
            place -= dvec2(0.98 + 1.52 * static_cast<double>(i), 0.85);
            place.x += 0.12 * (place.y - 1.0); // leaning like italics
            for (std::size_t s = 0; s < kStrokes.size(); ++s) {
                const double inside = 0.105 - strokeDistance(place, kStrokes[s]);
                const double cover = std::clamp(0.5 + inside * height / kDigitsAcross * 2.0, 0.0, 1.0);
                light = std::max(light, cover * (litStrokes(kYear[i])[s] == '1' ? 1.0 : 0.10));
            }
        }
        return dvec4(light, light, light, 1.0);
    });
}

} // namespace torrance::assets
