#include "files/gltf_extensions_used.h"

#include <algorithm>
#include <array>

namespace torrance {
namespace {

constexpr std::array<const char*, 5> kEditable = {"KHR_materials_unlit", "KHR_materials_ior",
                                                  "KHR_materials_emissive_strength", "KHR_texture_transform",
                                                  "EXT_texture_webp"};

/// As deep as reading lets it be (kMaxJsonDepth).
void collect(const OrderedJson& json, std::set<std::string>& found)
{
    if (json.is_object())
        if (const auto extensions = json.find("extensions"); extensions != json.end() && extensions->is_object())
            for (const char* name : kEditable)
                if (extensions->contains(name))
                    found.insert(name);
    if (json.is_structured())
        for (const OrderedJson& child : json)
            collect(child, found);
}

void add(OrderedJson& document, const char* list, const std::string& name)
{
    OrderedJson& names = document[list];
    if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
}

void remove(OrderedJson& document, const char* list, const std::string& name)
{
    const auto names = document.find(list);
    if (names == document.end())
        return;
    auto& array = names->get_ref<OrderedJson::array_t&>();
    std::erase(array, name);
    if (array.empty()) // glTF allows no empty list
        document.erase(list);
}

} // namespace

std::set<std::string> editableExtensionsIn(const OrderedJson& document)
{
    std::set<std::string> found;
    for (const char* array : {"materials", "textures"})
        if (const auto items = document.find(array); items != document.end())
            collect(*items, found);
    return found;
}

void updateExtensionLists(OrderedJson& document, const std::set<std::string>& before)
{
    const std::set<std::string> after = editableExtensionsIn(document);
    for (const std::string& name : after)
        if (!before.contains(name))
            add(document, "extensionsUsed", name);
    for (const std::string& name : before)
        if (!after.contains(name)) {
            remove(document, "extensionsUsed", name);
            remove(document, "extensionsRequired", name);
        }
}

void requireExtension(OrderedJson& document, const std::string& name)
{
    add(document, "extensionsUsed", name);
    add(document, "extensionsRequired", name);
}

} // namespace torrance
