#include "files/gltf_accessors.h"

#include "files/gltf_items.h"

#include <cstring>

namespace torrance {
namespace {

using nlohmann::json;

constexpr std::size_t kColumnAlignment = 4;

ComponentType componentType(const json& object, const std::string& item, const LoadReport& report)
{
    const auto value = object.at("componentType").get<std::int64_t>();
    for (const ComponentType type : {ComponentType::int8, ComponentType::uint8, ComponentType::int16,
                                     ComponentType::uint16, ComponentType::uint32, ComponentType::float32})
        if (value == static_cast<std::int64_t>(type))
            return type;
    report.fail(item, "has the unknown componentType " + std::to_string(value), kRepair);
}

void setShape(GltfAccessor& accessor, const std::string& type, const std::string& item, const LoadReport& report)
{
    struct Shape
    {
        const char* name;
        int rows;
        int columns;
    };
    constexpr Shape kShapes[] = {{"SCALAR", 1, 1}, {"VEC2", 2, 1}, {"VEC3", 3, 1}, {"VEC4", 4, 1},
                                 {"MAT2", 2, 2},   {"MAT3", 3, 3}, {"MAT4", 4, 4}};
    for (const Shape& shape : kShapes)
        if (type == shape.name) {
            accessor.rows = shape.rows;
            accessor.columns = shape.columns;
            return;
        }
    report.fail(item, "has the unknown type \"" + type + "\"", kRepair);
}

/// `count` elements of `elementBytes` each, `stride` apart, from `offset` on in `view`.
std::span<const std::byte> rangeOf(const GltfBufferView& view, std::size_t offset, std::size_t count,
                                   std::size_t stride, std::size_t elementBytes, std::size_t alignment,
                                   const std::string& item, const LoadReport& report)
{
    if ((view.offset + offset) % alignment != 0 || stride % alignment != 0)
        report.fail(item, "is misaligned: its offset and stride are not multiples of " + std::to_string(alignment),
                    kRepair);
    if (stride < elementBytes)
        report.fail(item,
                    "has elements of " + std::to_string(elementBytes) + " bytes that overlap, being " +
                        std::to_string(stride) + " apart",
                    kRepair);
    // No overflow: counts and offsets are below 2^53, strides at most 252.
    const std::size_t end = offset + stride * (count - 1) + elementBytes;
    if (end > view.bytes.size())
        report.fail(item,
                    "reads up to byte " + std::to_string(end) + " of a buffer view of " +
                        std::to_string(view.bytes.size()),
                    kRepair);
    return view.bytes.subspan(offset);
}

SparseElements checkSparse(const json& object, const GltfAccessor& accessor, const GltfBuffers& buffers,
                           const std::string& item, const LoadReport& report)
{
    SparseElements sparse;
    sparse.count = object.at("count").get<std::size_t>();
    if (sparse.count == 0 || sparse.count > accessor.count)
        report.fail(item,
                    "replaces " + std::to_string(sparse.count) + " of " + std::to_string(accessor.count) + " elements",
                    kRepair);

    const json& indices = object.at("indices");
    sparse.indexType = componentType(indices, item + "/indices", report);
    const std::size_t indexBytes = bytesOf(sparse.indexType);
    if (sparse.indexType != ComponentType::uint8 && sparse.indexType != ComponentType::uint16 &&
        sparse.indexType != ComponentType::uint32)
        report.fail(item + "/indices", "are not unsigned integers", kRepair);
    sparse.indices =
        rangeOf(buffers.views[indices.at("bufferView").get<std::size_t>()], indices.value("byteOffset", std::size_t(0)),
                sparse.count, indexBytes, indexBytes, indexBytes, item + "/indices", report);

    const json& values = object.at("values");
    const std::size_t elementBytes = accessor.columnBytes() * static_cast<std::size_t>(accessor.columns);
    sparse.values =
        rangeOf(buffers.views[values.at("bufferView").get<std::size_t>()], values.value("byteOffset", std::size_t(0)),
                sparse.count, elementBytes, elementBytes, bytesOf(accessor.component), item + "/values", report);

    for (std::size_t i = 0; i < sparse.count; ++i) {
        const std::uint32_t index = sparse.index(i);
        if (index >= accessor.count || (i > 0 && index <= sparse.index(i - 1)))
            report.fail(item + "/indices", "do not increase, or pass the accessor's end, at " + std::to_string(i),
                        kRepair);
    }
    return sparse;
}

GltfAccessor checkAccessor(const json& object, const std::string& item, const GltfBuffers& buffers,
                           const LoadReport& report)
{
    GltfAccessor accessor;
    accessor.component = componentType(object, item, report);
    setShape(accessor, object.at("type").get_ref<const std::string&>(), item, report);
    accessor.normalized = object.value("normalized", false);
    accessor.count = object.at("count").get<std::size_t>();
    if (accessor.count == 0)
        report.fail(item, "has a count of 0", kRepair);
    if (accessor.normalized &&
        (accessor.component == ComponentType::float32 || accessor.component == ComponentType::uint32))
        report.fail(item, "normalizes a type that glTF does not normalize", kRepair);

    const std::size_t packed = accessor.columnBytes() * static_cast<std::size_t>(accessor.columns);
    accessor.stride = packed;
    if (const auto view = object.find("bufferView"); view != object.end()) {
        const GltfBufferView& source = buffers.views[view->get<std::size_t>()];
        accessor.stride = source.stride != 0 ? source.stride : packed;
        accessor.bytes = rangeOf(source, object.value("byteOffset", std::size_t(0)), accessor.count, accessor.stride,
                                 packed, bytesOf(accessor.component), item, report);
    } else if (accessor.count > kMaxElementsWithoutData)
        report.fail(item,
                    "has " + std::to_string(accessor.count) + " elements and no data, where " +
                        std::to_string(kMaxElementsWithoutData) + " is the most",
                    kRepair);
    if (const auto sparse = object.find("sparse"); sparse != object.end())
        accessor.sparse = checkSparse(*sparse, accessor, buffers, item + "/sparse", report);
    return accessor;
}

} // namespace

std::size_t bytesOf(ComponentType type)
{
    switch (type) {
    case ComponentType::int8:
    case ComponentType::uint8:
        return 1;
    case ComponentType::int16:
    case ComponentType::uint16:
        return 2;
    default:
        return 4;
    }
}

std::uint32_t SparseElements::index(std::size_t i) const
{
    std::uint32_t value = 0; // little-endian: the low bytes come first
    std::memcpy(&value, indices.data() + i * bytesOf(indexType), bytesOf(indexType));
    return value;
}

std::size_t GltfAccessor::columnBytes() const
{
    const std::size_t used = bytesOf(component) * static_cast<std::size_t>(rows);
    return columns == 1 ? used : (used + kColumnAlignment - 1) / kColumnAlignment * kColumnAlignment;
}

std::vector<GltfAccessor> checkAccessors(const json& document, const GltfBuffers& buffers, const LoadReport& report)
{
    const json& objects = itemsOf(document, "accessors");
    std::vector<GltfAccessor> accessors;
    accessors.reserve(objects.size());
    for (std::size_t i = 0; i < objects.size(); ++i)
        accessors.push_back(checkAccessor(objects[i], itemName("accessors", i), buffers, report));
    return accessors;
}

} // namespace torrance
