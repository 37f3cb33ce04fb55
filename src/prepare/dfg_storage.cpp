#include "prepare/dfg_storage.h"

#include "image/quantize.h"
#include "math/half.h"

#include <cstring>
#include <span>

namespace torrance {

DfgTable dfgWithNodes(const DfgTable& table, int width, int height)
{
    if (width == table.width && height == table.height)
        return table;
    DfgTable result{width, height, {}};
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const vec4 terms = lookUpDfg(table, static_cast<float>(dfgNoV(static_cast<double>(column) / (width - 1))),
                                         static_cast<float>(dfgRoughness(static_cast<double>(row) / (height - 1))));
            for (int i = 0; i < 4; ++i)
                result.texels.push_back(terms[i]);
        }
    return result;
}

std::vector<std::byte> packDfg(const DfgTable& table, brdf::DfgFormat format)
{
    if (format == brdf::DfgFormat::float32) {
        const auto bytes = std::as_bytes(std::span(table.texels));
        return {bytes.begin(), bytes.end()};
    }
    std::vector<std::uint16_t> codes;
    for (const float value : table.texels)
        codes.push_back(format == brdf::DfgFormat::float16 ? toHalf(value) : quantized(value, 65535));
    const auto bytes = std::as_bytes(std::span(codes));
    return {bytes.begin(), bytes.end()};
}

} // namespace torrance
