// The elements of a checked accessor as numbers.
#pragma once

#include "files/gltf_accessors.h"
#include "math/vector.h"

namespace torrance {

/// count * rows * columns floats, matrices by columns: strides, normalisation and sparse replacements resolved.
/// Normalised integers are c/255, c/65535, max(c/127, -1), max(c/32767, -1) (glTF 2.0, 3.11), computed in double and
/// rounded once. NaN and Inf become 0 and are counted in `report`.
std::vector<float> readNumbers(const GltfAccessor& accessor, LoadReport& report);

/// A scalar accessor of unsigned integers.
std::vector<std::uint32_t> readIndices(const GltfAccessor& accessor);

/// Vectors of N floats; the accessor has N rows and one column.
template <int N>
std::vector<glm::vec<N, float>> readVectors(const GltfAccessor& accessor, LoadReport& report)
{
    const std::vector<float> numbers = readNumbers(accessor, report);
    std::vector<glm::vec<N, float>> vectors(accessor.count);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (int k = 0; k < N; ++k)
            vectors[i][k] = numbers[i * N + static_cast<std::size_t>(k)];
    return vectors;
}

} // namespace torrance
