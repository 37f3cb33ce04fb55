#include "files/gltf_extensions.h"

#include "files/gltf_items.h"

#include <array>

namespace torrance {
namespace {

constexpr std::array<std::string_view, 8> kSupported = {
    "EXT_mesh_gpu_instancing", "EXT_texture_webp",    "KHR_lights_punctual",   "KHR_materials_emissive_strength",
    "KHR_materials_ior",       "KHR_materials_unlit", "KHR_mesh_quantization", "KHR_texture_transform",
};

} // namespace

std::span<const std::string_view> supportedExtensions()
{
    return kSupported;
}

bool isSupportedExtension(std::string_view name)
{
    return std::find(kSupported.begin(), kSupported.end(), name) != kSupported.end();
}

std::vector<std::string> extensionNames(const nlohmann::json& document, const char* array)
{
    return itemsOf(document, array).get<std::vector<std::string>>();
}

void checkExtensions(const nlohmann::json& document, LoadReport& report)
{
    std::string missing;
    std::vector<std::string> required = extensionNames(document, "extensionsRequired");
    for (const std::string& name : required)
        if (!isSupportedExtension(name))
            missing += (missing.empty() ? "" : ", ") + name;
    if (!missing.empty())
        report.fail("extensionsRequired", "the file cannot be drawn without " + missing + ", which is not supported",
                    "export it without that extension");
    for (const std::string& name : extensionNames(document, "extensionsUsed"))
        if (!isSupportedExtension(name))
            report.warn("", "uses " + name + ", which is not supported and left out");
}

} // namespace torrance
