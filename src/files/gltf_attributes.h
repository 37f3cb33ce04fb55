// Vertex attributes: which formats glTF allows for each, and their values.
#pragma once

#include "files/gltf_accessors.h"
#include "math/vector.h"

#include <map>

namespace torrance {

/// Reads the attributes of one mesh primitive, or of one of its morph targets.
class GltfAttributes
{
public:
    /// `attributes` maps semantics to accessors; `item` names the primitive. All must have as many elements as there
    /// are `vertices`, and a format that glTF or KHR_mesh_quantization allows: Errors (input) otherwise. A quantized
    /// format in a file that does not declare the extension is a warning.
    GltfAttributes(const std::map<std::string, int>& attributes, const std::vector<GltfAccessor>& accessors,
                   std::size_t vertices, bool quantizationDeclared, const std::string& item, LoadReport& report);

    bool has(const std::string& semantic) const;

    /// Empty where the semantic is absent. N is the number of components; a colour of three gets an alpha of one.
    template <int N>
    std::vector<glm::vec<N, float>> read(const std::string& semantic) const;

private:
    const GltfAccessor* find(const std::string& semantic) const;

    const std::map<std::string, int>& attributes;
    const std::vector<GltfAccessor>& accessors;
    LoadReport& report;
};

} // namespace torrance
