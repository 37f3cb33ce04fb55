#include "files/gltf_model.h"

#include "files/gltf_items.h"

namespace torrance {
namespace {

using nlohmann::json;

bool isBulk(const std::string& array)
{
    for (const char* bulk : {"buffers", "bufferViews", "images", "accessors", "animations"})
        if (array == bulk)
            return true;
    return false;
}

json structureOf(const json& document)
{
    json structure;
    for (const auto& [array, value] : document.items())
        if (!isBulk(array))
            structure[array] = value;
    const std::size_t accessors = itemsOf(document, "accessors").size();
    structure["bufferViews"] = json::array({{{"buffer", 0}, {"byteLength", 1}}});
    const json name = {{"bufferView", 0}, {"componentType", 5121}, {"count", 1}, {"type", "SCALAR"}};
    structure["accessors"] = json::array_t(accessors, name);
    return structure;
}

/// tinygltf drops a primitive that it cannot read without a word.
void checkPrimitiveCounts(const json& document, const tinygltf::Model& model, const LoadReport& report)
{
    const json& meshes = itemsOf(document, "meshes");
    for (std::size_t i = 0; i < meshes.size(); ++i)
        if (itemsOf(meshes[i], "primitives").size() != model.meshes.at(i).primitives.size())
            report.fail(itemName("meshes", i), "has a primitive that cannot be read", kRepair);
}

std::string joinedLines(std::string text)
{
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

} // namespace

tinygltf::Model readModel(const json& document, const LoadReport& report)
{
    const std::string text = structureOf(document).dump();
    tinygltf::TinyGLTF reader;
    tinygltf::Model model;
    std::string problem;
    std::string warning;
    if (!reader.LoadASCIIFromString(&model, &problem, &warning, text.data(), static_cast<unsigned>(text.size()), "",
                                    tinygltf::REQUIRE_VERSION))
        report.fail("the document", joinedLines(problem), kRepair);
    checkPrimitiveCounts(document, model, report);
    return model;
}

} // namespace torrance
