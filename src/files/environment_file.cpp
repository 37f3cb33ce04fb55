#include "files/environment_file.h"

#include "files/image_read.h"
#include "image/srgb.h"

#include <limits>
#include <utility>

namespace torrance {
namespace {

// Returns how many values were no radiance.
std::size_t replaceBadValues(Image& image)
{
    std::size_t count = 0;
    constexpr float kGreatest = std::numeric_limits<float>::max();
    for (float& value : image.texels)
        if (!(value >= 0.0f && value <= kGreatest)) {
            value = 0.0f;
            ++count;
        }
    return count;
}

void decodeSrgb(Image& image)
{
    for (float& value : image.texels)
        value = srgbDecode(value);
}

} // namespace

LoadedEnvironment loadEnvironment(const std::string& path)
{
    ReadImage picture = readImage(path);
    const bool displayReferred = picture.displayReferred;
    LoadedEnvironment environment{.radiance = colorOf(std::move(picture), path), .replaced = 0, .warnings = {}};
    Image& radiance = environment.radiance;
    if (displayReferred) {
        decodeSrgb(radiance);
        environment.warnings.push_back(path +
                                       ": display-referred, so that nothing is brighter than white; prefer HDR or EXR");
    }
    environment.replaced = replaceBadValues(radiance);
    if (environment.replaced > 0)
        environment.warnings.push_back(path + ": " + std::to_string(environment.replaced) +
                                       " values are NaN, Inf or negative and count as 0");
    if (radiance.width != 2 * radiance.height)
        environment.warnings.push_back(path + ": is " + std::to_string(radiance.width) + "x" +
                                       std::to_string(radiance.height) +
                                       ", not twice as wide as high; stretched to a panorama");
    return environment;
}

} // namespace torrance
