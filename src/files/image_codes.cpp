#include "files/image_codes.h"

#include "image/quantize.h"

#include <algorithm>

namespace torrance {

std::vector<std::uint8_t> codes8(const Image& image)
{
    std::vector<std::uint8_t> codes(image.texels.size());
    std::transform(image.texels.begin(), image.texels.end(), codes.begin(),
                   [](float value) { return static_cast<std::uint8_t>(quantized(value, 255)); });
    return codes;
}

std::vector<std::uint8_t> codes16(const Image& image)
{
    std::vector<std::uint8_t> codes;
    codes.reserve(image.texels.size() * 2);
    for (const float value : image.texels) {
        const std::uint16_t code = quantized(value, 65535);
        codes.push_back(static_cast<std::uint8_t>(code >> 8));
        codes.push_back(static_cast<std::uint8_t>(code & 0xff));
    }
    return codes;
}

} // namespace torrance
