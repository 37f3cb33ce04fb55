#include "files/gltf_attributes.h"

#include "files/gltf_elements.h"

#include <string_view>

namespace torrance {
namespace {

/// A set of component formats, one bit each.
enum Format : unsigned
{
    float32 = 1,
    uint8 = 2,
    uint8Normalized = 4,
    uint16 = 8,
    uint16Normalized = 16,
    int8 = 32,
    int8Normalized = 64,
    int16 = 128,
    int16Normalized = 256,
};

constexpr unsigned kNormalizedColor = float32 | uint8Normalized | uint16Normalized;
constexpr unsigned kSigned = int8Normalized | int16Normalized;
constexpr unsigned kAnySmall =
    uint8 | uint8Normalized | uint16 | uint16Normalized | int8 | int8Normalized | int16 | int16Normalized;

/// glTF 2.0, 3.7.2.1, and KHR_mesh_quantization, "Extending Mesh Attributes" and "Extending Morph Target Attributes".
struct Rule
{
    std::string_view semantic; // ending in _ where a number follows
    int least;                 // components
    int most;
    unsigned core;
    unsigned quantized;
};

constexpr Rule kRules[] = {
    {"POSITION", 3, 3, float32, kAnySmall},
    {"NORMAL", 3, 3, float32, kSigned},
    {"TANGENT", 3, 4, float32, kSigned}, // 3 in a morph target
    {"TEXCOORD_", 2, 2, kNormalizedColor, kAnySmall},
    {"COLOR_", 3, 4, kNormalizedColor, 0},
    {"JOINTS_", 4, 4, uint8 | uint16, 0},
    {"WEIGHTS_", 4, 4, kNormalizedColor, 0},
};

unsigned formatOf(const GltfAccessor& accessor)
{
    switch (accessor.component) {
    case ComponentType::float32:
        return float32;
    case ComponentType::uint8:
        return accessor.normalized ? uint8Normalized : uint8;
    case ComponentType::uint16:
        return accessor.normalized ? uint16Normalized : uint16;
    case ComponentType::int8:
        return accessor.normalized ? int8Normalized : int8;
    case ComponentType::int16:
        return accessor.normalized ? int16Normalized : int16;
    case ComponentType::uint32:
        break;
    }
    return 0;
}

const Rule* ruleFor(const std::string& semantic)
{
    for (const Rule& rule : kRules)
        if (semantic == rule.semantic || (rule.semantic.back() == '_' && semantic.starts_with(rule.semantic)))
            return &rule;
    return nullptr; // the application's own
}

void check(const GltfAccessor& accessor, const Rule& rule, std::size_t vertices, bool quantizationDeclared,
           const std::string& item, LoadReport& report)
{
    if (accessor.count != vertices)
        report.fail(
            item, "has " + std::to_string(accessor.count) + " elements where POSITION has " + std::to_string(vertices),
            kRepair);
    const unsigned format = formatOf(accessor);
    if (accessor.columns != 1 || accessor.rows < rule.least || accessor.rows > rule.most ||
        (format & (rule.core | rule.quantized)) == 0)
        report.fail(item, "has a format that glTF does not allow for it", kRepair);
    if ((format & rule.core) == 0 && !quantizationDeclared)
        report.warn(item, "is quantized, but the file does not declare KHR_mesh_quantization");
}

} // namespace

GltfAttributes::GltfAttributes(const std::map<std::string, int>& semantics, const std::vector<GltfAccessor>& all,
                               std::size_t vertices, bool quantizationDeclared, const std::string& item,
                               LoadReport& messages)
    : attributes(semantics), accessors(all), report(messages)
{
    for (const auto& [semantic, index] : attributes)
        if (const Rule* rule = ruleFor(semantic))
            check(accessors[static_cast<std::size_t>(index)], *rule, vertices, quantizationDeclared,
                  item + "/" + semantic, report);
}

bool GltfAttributes::has(const std::string& semantic) const
{
    return attributes.contains(semantic);
}

const GltfAccessor* GltfAttributes::find(const std::string& semantic) const
{
    const auto found = attributes.find(semantic);
    return found == attributes.end() ? nullptr : &accessors[static_cast<std::size_t>(found->second)];
}

template <int N>
std::vector<glm::vec<N, float>> GltfAttributes::read(const std::string& semantic) const
{
    const GltfAccessor* accessor = find(semantic);
    if (accessor == nullptr)
        return {};
    const std::vector<float> numbers = readNumbers(*accessor, report);
    const int given = std::min(accessor->rows, N);
    std::vector<glm::vec<N, float>> vectors(accessor->count, glm::vec<N, float>(1.0f));
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (int k = 0; k < given; ++k)
            vectors[i][k] = numbers[i * static_cast<std::size_t>(accessor->rows) + static_cast<std::size_t>(k)];
    return vectors;
}

template std::vector<vec2> GltfAttributes::read<2>(const std::string&) const;
template std::vector<vec3> GltfAttributes::read<3>(const std::string&) const;
template std::vector<vec4> GltfAttributes::read<4>(const std::string&) const;

} // namespace torrance
