#include "files/mtl_file.h"

#include "files/mtl_text.h"
#include "files/read_file.h"

#include <map>
#include <stdexcept>

namespace torrance {

std::vector<MtlMaterial> readMtlFile(const std::filesystem::path& path, LoadReport& report)
{
    // What is wrong in here is about this file, not about the one that names it.
    LoadReport own;
    own.file = path.string();
    const std::vector<std::byte> bytes = readFile(path, own.file, "");
    if (bytes.size() > kMaxMtlBytes)
        own.fail("", "is larger than 100 MiB", "leave out the materials that the model does not use");
    const MtlText text = readMtlText({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, own);
    report.add(own);
    if (text.materials.empty())
        return {};

    std::map<std::string, int> numbers;
    std::vector<tinyobj::material_t> parsed;
    std::string warning, failure;
    ViewStream stream(text.statements);
    tinyobj::LoadMtl(&numbers, &parsed, &stream, &warning, &failure);
    if (parsed.size() != text.materials.size())
        throw std::runtime_error("tinyobjloader cannot read " + own.file);
    std::vector<MtlMaterial> materials;
    for (std::size_t i = 0; i < parsed.size(); ++i)
        materials.push_back({text.materials[i].name, own.file, text.materials[i].keys, std::move(parsed[i])});
    return materials;
}

} // namespace torrance
