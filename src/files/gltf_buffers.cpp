#include "files/gltf_buffers.h"

#include "files/gltf_items.h"
#include "files/gltf_uri.h"
#include "files/read_file.h"

namespace torrance {
namespace {

using nlohmann::json;

/// glTF 2.0, bufferView.byteStride: the largest stride allowed.
constexpr std::size_t kMaxStride = 252;

std::vector<bool> usedBuffers(const json& document)
{
    std::vector<bool> used(itemsOf(document, "buffers").size());
    for (const json& view : itemsOf(document, "bufferViews"))
        used[view.at("buffer").get<std::size_t>()] = true;
    return used;
}

/// The source's bytes: in the GLB, in the document, or in a file of which no more than needed is read.
std::span<const std::byte> source(const json& buffer, std::size_t index, const GltfContainer& container,
                                  const GltfOrigin& origin, const LoadReport& report, GltfBuffers& buffers)
{
    const std::string item = itemName("buffers", index);
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) {
        if (index == 0 && container.binary)
            return *container.binary;
        report.fail(item, "has no data (no URI, and no binary chunk of a GLB)", "pack its data into the file");
    }
    const auto& text = uri->get_ref<const std::string&>();
    if (auto data = dataOfUri(text, report.file, item))
        return buffers.storage.emplace_back(std::move(*data));
    const auto path = pathOfUri(text, origin.folder, origin.allowExternal, report.file, item);
    const auto length = buffer.at("byteLength").get<std::uint64_t>();
    return buffers.storage.emplace_back(readFile(path, report.file, item + " (" + path.string() + ")", length));
}

GltfBufferView viewOf(const json& view, std::size_t index, const std::vector<std::span<const std::byte>>& sources,
                      const LoadReport& report)
{
    const std::span<const std::byte> bytes = sources[view.at("buffer").get<std::size_t>()];
    const auto offset = view.value("byteOffset", std::size_t(0));
    const auto length = view.at("byteLength").get<std::size_t>();
    const auto stride = view.value("byteStride", std::size_t(0));
    const std::string item = itemName("bufferViews", index);
    if (offset > bytes.size() || length > bytes.size() - offset)
        report.fail(
            item, "ends at byte " + std::to_string(offset + length) + " of a buffer of " + std::to_string(bytes.size()),
            kRepair);
    if (stride > kMaxStride)
        report.fail(item, "has a stride of " + std::to_string(stride) + " bytes where 252 is the most", kRepair);
    return {bytes.subspan(offset, length), offset, stride};
}

} // namespace

GltfBuffers readBuffers(const json& document, const GltfContainer& container, const GltfOrigin& origin,
                        const LoadReport& report)
{
    GltfBuffers buffers;
    const std::vector<bool> used = usedBuffers(document);
    std::vector<std::span<const std::byte>> sources(used.size());
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i])
            continue;
        const json& buffer = document.at("buffers")[i];
        const auto length = buffer.at("byteLength").get<std::size_t>();
        buffers.totalBytes += length;
        if (buffers.totalBytes > kMaxFileBytes)
            report.fail(itemName("buffers", i), "brings the buffers to more than 4 GiB", "split the model");
        const auto bytes = source(buffer, i, container, origin, report, buffers);
        if (bytes.size() < length)
            report.fail(itemName("buffers", i),
                        "claims " + std::to_string(length) + " bytes where its source has " +
                            std::to_string(bytes.size()),
                        kRepair);
        sources[i] = bytes.first(length);
    }
    const json& views = itemsOf(document, "bufferViews");
    for (std::size_t i = 0; i < views.size(); ++i)
        buffers.views.push_back(viewOf(views[i], i, sources, report));
    return buffers;
}

} // namespace torrance
