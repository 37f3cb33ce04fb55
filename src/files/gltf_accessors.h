// Accessors, checked once, so that reading them needs no more checks.
#pragma once

#include "files/gltf_buffers.h"
#include "files/load_report.h"

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace torrance {

enum class ComponentType : int
{
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    uint32 = 5125,
    float32 = 5126,
};

std::size_t bytesOf(ComponentType type);

/// An accessor without a buffer view reads as zeros, and its count is not bounded by any bytes of the file. This many
/// elements is what one picture's largest meshes have; more is refused.
inline constexpr std::size_t kMaxElementsWithoutData = std::size_t(1) << 24;

struct SparseElements
{
    std::size_t count = 0;
    ComponentType indexType = ComponentType::uint8;
    std::span<const std::byte> indices; // strictly increasing, below the accessor's count
    std::span<const std::byte> values;  // packed

    std::uint32_t index(std::size_t i) const;
};

struct GltfAccessor
{
    ComponentType component = ComponentType::float32;
    int rows = 1;    // 1 to 4: SCALAR, VEC2..4, or the rows of a matrix
    int columns = 1; // above 1 for matrices
    bool normalized = false;
    std::size_t count = 0;
    std::span<const std::byte> bytes; // from the first element on; empty where all elements start as zeros
    std::size_t stride = 0;           // bytes from element to element
    std::optional<SparseElements> sparse;

    /// Columns of matrices start at multiples of four bytes (glTF 2.0, 3.6.2.4).
    std::size_t columnBytes() const;
    bool isVector(int n) const { return rows == n && columns == 1; }
};

/// All accessors of `document` (checked by checkSchema). Errors (input): unknown type, a count of zero or beyond what
/// its view holds, misaligned, elements that overlap, sparse indices that do not increase or lie past the end.
std::vector<GltfAccessor> checkAccessors(const nlohmann::json& document, const GltfBuffers& buffers,
                                         const LoadReport& report);

} // namespace torrance
