#include "files/gltf_elements.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace torrance {
namespace {

template <typename T>
T valueAt(const std::byte* place)
{
    T value;
    std::memcpy(&value, place, sizeof value);
    return value;
}

template <typename T>
float toFloat(T value, bool normalized)
{
    if constexpr (std::is_floating_point_v<T>)
        return value;
    else if (!normalized)
        return static_cast<float>(value);
    else
        return static_cast<float>(
            std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0));
}

/// Calls use(T{}) with the C++ type of a component.
template <typename Use>
void withType(ComponentType type, Use&& use)
{
    switch (type) {
    case ComponentType::int8:
        return use(std::int8_t{});
    case ComponentType::uint8:
        return use(std::uint8_t{});
    case ComponentType::int16:
        return use(std::int16_t{});
    case ComponentType::uint16:
        return use(std::uint16_t{});
    case ComponentType::uint32:
        return use(std::uint32_t{});
    case ComponentType::float32:
        return use(float{});
    }
}

template <typename T>
void readElement(const std::byte* place, const GltfAccessor& accessor, float* numbers)
{
    for (int column = 0; column < accessor.columns; ++column)
        for (int row = 0; row < accessor.rows; ++row)
            *numbers++ = toFloat(valueAt<T>(place + accessor.columnBytes() * static_cast<std::size_t>(column) +
                                            sizeof(T) * static_cast<std::size_t>(row)),
                                 accessor.normalized);
}

/// Calls write(element, bytes) for every element that a sparse accessor replaces; `packed` is the size of one.
template <typename Write>
void forEachReplaced(const GltfAccessor& accessor, std::size_t packed, Write&& write)
{
    if (!accessor.sparse)
        return;
    for (std::size_t i = 0; i < accessor.sparse->count; ++i)
        write(accessor.sparse->index(i), accessor.sparse->values.data() + i * packed);
}

std::size_t replaceNonFinite(std::vector<float>& numbers)
{
    std::size_t replaced = 0;
    for (float& number : numbers)
        if (!std::isfinite(number)) {
            number = 0.0f;
            ++replaced;
        }
    return replaced;
}

} // namespace

std::vector<float> readNumbers(const GltfAccessor& accessor, LoadReport& report)
{
    const std::size_t width = static_cast<std::size_t>(accessor.rows) * static_cast<std::size_t>(accessor.columns);
    const std::size_t packed = accessor.columnBytes() * static_cast<std::size_t>(accessor.columns);
    std::vector<float> numbers(accessor.count * width, 0.0f);
    withType(accessor.component, [&](auto component) {
        using T = decltype(component);
        if (!accessor.bytes.empty())
            for (std::size_t i = 0; i < accessor.count; ++i)
                readElement<T>(accessor.bytes.data() + i * accessor.stride, accessor, numbers.data() + i * width);
        forEachReplaced(accessor, packed, [&](std::size_t element, const std::byte* value) {
            readElement<T>(value, accessor, numbers.data() + element * width);
        });
    });
    if (accessor.component == ComponentType::float32)
        report.nonFiniteNumbers += replaceNonFinite(numbers);
    return numbers;
}

std::vector<std::uint32_t> readIndices(const GltfAccessor& accessor)
{
    std::vector<std::uint32_t> indices(accessor.count, 0u);
    withType(accessor.component, [&](auto component) {
        using T = decltype(component);
        if constexpr (std::is_unsigned_v<T>) {
            if (!accessor.bytes.empty())
                for (std::size_t i = 0; i < accessor.count; ++i)
                    indices[i] = valueAt<T>(accessor.bytes.data() + i * accessor.stride);
            forEachReplaced(accessor, sizeof(T),
                            [&](std::size_t element, const std::byte* value) { indices[element] = valueAt<T>(value); });
        }
    });
    return indices;
}

} // namespace torrance
