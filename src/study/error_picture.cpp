#include "study/error_picture.h"

#include "measure/heat_map.h"

#include <cmath>

namespace torrance {

Image errorPicture(const Image& errors)
{
    constexpr float kDecades = 6.0f;
    Image levels = errors;
    for (float& level : levels.texels)
        level = level > 0.0f ? (std::log10(level) + kDecades) / kDecades : 0.0f;
    return heatMap(levels);
}

} // namespace torrance
