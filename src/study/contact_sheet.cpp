#include "study/contact_sheet.h"

#include <algorithm>
#include <cassert>

namespace torrance {
namespace {

void place(Image& sheet, const Image& picture, int zoom, int left, int top)
{
    for (int y = 0; y < picture.height * zoom; ++y)
        for (int x = 0; x < picture.width * zoom; ++x) {
            float* to = sheet.at(left + x, top + y);
            std::copy_n(picture.at(x / zoom, y / zoom), picture.channels, to);
            if (picture.channels == 3)
                to[3] = 1.0f;
        }
}

} // namespace

Image contactSheet(std::span<const Image> pictures, int columns)
{
    assert(!pictures.empty() && columns > 0);
    const int width = std::ranges::max(pictures, {}, &Image::width).width;
    const int height = std::ranges::max(pictures, {}, &Image::height).height;
    const int count = static_cast<int>(pictures.size());
    const int across = std::min(columns, count), down = (count + columns - 1) / columns;
    Image sheet(across * (width + kSheetGap) - kSheetGap, down * (height + kSheetGap) - kSheetGap, 4);
    for (int i = 0; i < count; ++i) {
        const Image& picture = pictures[static_cast<std::size_t>(i)];
        const int zoom = std::min(width / picture.width, height / picture.height);
        place(sheet, picture, zoom, i % columns * (width + kSheetGap), i / columns * (height + kSheetGap));
    }
    return sheet;
}

} // namespace torrance
