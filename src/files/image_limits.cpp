#include "files/image_limits.h"

#include "core/error.h"

namespace torrance {

void checkImageSize(long long width, long long height, long long channels, const std::string& file)
{
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    if (width <= 0 || height <= 0 || channels <= 0)
        throw inputError(file, "", "the picture is " + size + " with " + std::to_string(channels) + " channels",
                         "give it at least one texel");
    if (width > kMaxImageSide || height > kMaxImageSide || width * height > kMaxImageValues / channels)
        throw inputError(file, "", "the picture is " + size + " with " + std::to_string(channels) + " channels",
                         "shrink it to at most " + std::to_string(kMaxImageSide) +
                             " texels a side and 2 GiB of floats");
}

} // namespace torrance
