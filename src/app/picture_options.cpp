#include "app/picture_options.h"

#include "app/option_value.h"
#include "core/error.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <unistd.h>

namespace torrance {
namespace {

// A whole picture is 16 bytes a pixel in several copies: beyond this no machine that we know of holds it.
constexpr int kMaxSide = 32768;

dvec3 parseColor(const std::string& text)
{
    const auto color = parseHexColor(text);
    if (!color)
        throw usageError("--background " + text + ": not a background",
                         "it takes environment, transparent or a colour such as #336699");
    return *color;
}

} // namespace

void declarePictureOptions(CLI::App& app, PictureOptions& options)
{
    app.add_option("-r,--resolution", options.resolution, "Size of the picture (default 1024x1024)")
        ->group("Output")
        ->type_name("WxH");
    app.add_option("--background", options.background, "environment (default), #RRGGBB (sRGB) or transparent")
        ->group("Output")
        ->type_name("KIND");
    app.add_flag("--no-background", options.noBackground, "The same as --background transparent")->group("Output");
}

ivec2 chosenSize(const PictureOptions& options)
{
    std::string commas = options.resolution;
    std::ranges::replace_if(
        commas, [](char c) { return c == 'x' || c == 'X'; }, ',');
    const std::vector<double> sides = parseNumbers("--resolution", commas, 2, 2);
    for (const double side : sides)
        if (side != std::floor(side) || side < 1 || side > kMaxSide)
            throw usageError("--resolution " + options.resolution + ": sides must be whole numbers from 1 to " +
                                 std::to_string(kMaxSide),
                             "1024x1024 is the default");
    return {static_cast<int>(sides[0]), static_cast<int>(sides[1])};
}

Background chosenBackground(const PictureOptions& options)
{
    const std::string& kind = options.background;
    if (options.noBackground && kind != "environment" && kind != "transparent")
        throw usageError("--no-background and --background " + kind + " exclude each other", "give one of them");
    if (options.noBackground || kind == "transparent")
        return {BackgroundKind::transparent, dvec3(0.0)};
    if (kind == "environment")
        return {};
    return {BackgroundKind::color, parseColor(kind)};
}

void checkMemory(const PictureOptions& options, double bytesPerPixel)
{
    const ivec2 size = chosenSize(options);
    const double bytes = double(size.x) * size.y * bytesPerPixel;
    const double available = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
    if (bytes > available)
        throw usageError("--resolution " + options.resolution + " needs " +
                             std::to_string(static_cast<long>(std::ceil(bytes / 0x1p30))) +
                             " GiB, more than this machine has",
                         "choose a smaller picture");
}

} // namespace torrance
