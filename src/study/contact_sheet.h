// Many small pictures as one.
#pragma once

#include "image/image.h"

#include <span>

namespace torrance {

/// Row by row, `columns` beside each other, kSheetGap texels apart, on nothing: 4 channels. Pictures of fewer texels
/// are enlarged by the greatest whole factor that fits the largest. `pictures` are display-encoded, of 3 channels or 4
/// with straight alpha, and there is at least one.
Image contactSheet(std::span<const Image> pictures, int columns);

inline constexpr int kSheetGap = 2;

} // namespace torrance
