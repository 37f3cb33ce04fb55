#include "files/gltf_material_write.h"

#include "files/uv_transform.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

using Pointer = OrderedJson::json_pointer;

constexpr const char* kStrength = "/extensions/KHR_materials_emissive_strength/emissiveStrength";

/// Takes a member away, and the objects that held nothing else.
void drop(OrderedJson& json, Pointer place)
{
    if (!json.contains(place))
        return;
    do {
        json[place.parent_pointer()].erase(place.back());
        place = place.parent_pointer();
    } while (!place.empty() && json[place].empty());
}

/// Writes a member, or leaves it out where it has its default.
template <typename Value>
void put(OrderedJson& json, const Pointer& place, const Value& value, bool isDefault)
{
    if (isDefault)
        drop(json, place);
    else
        json[place] = value;
}

template <glm::length_t N>
OrderedJson numbers(const glm::vec<N, double>& vector)
{
    OrderedJson array = OrderedJson::array();
    for (glm::length_t i = 0; i < N; ++i)
        array.push_back(vector[i]);
    return array;
}

const char* nameOf(AlphaMode mode)
{
    return mode == AlphaMode::opaque ? "OPAQUE" : mode == AlphaMode::mask ? "MASK" : "BLEND";
}

/// Whether factor * strength, which is what is read, gives `emissive`, with factors of at most one.
bool gives(double strength, const dvec3& emissive)
{
    for (int i = 0; i < 3; ++i)
        if (const double factor = emissive[i] / strength; !(factor <= 1.0) || factor * strength != emissive[i])
            return false;
    return true;
}

/// The strength of KHR_materials_emissive_strength: the file's where it still serves, the largest component where that
/// loses no bit, else the next power of two, by which a division is exact.
double strengthFor(const dvec3& emissive, double old)
{
    const double largest = std::max({emissive.x, emissive.y, emissive.z});
    if (!(largest > 1.0))
        return 1.0;
    for (const double strength : {old, largest})
        if (strength > 1.0 && gives(strength, emissive))
            return strength;
    return std::exp2(std::ceil(std::log2(largest)));
}

void writeEmissive(OrderedJson& json, const dvec3& emissive)
{
    const Pointer place(kStrength);
    const double strength = strengthFor(emissive, json.contains(place) ? json[place].get<double>() : 1.0);
    put(json, Pointer("/emissiveFactor"), numbers(emissive / strength), emissive == dvec3(0.0));
    put(json, place, strength, strength == 1.0);
}

void writeTransform(OrderedJson& json, const Pointer& info, const TextureUse& before, const TextureUse& after)
{
    const Pointer place = info / "extensions" / "KHR_texture_transform";
    put(json, place / "offset", numbers(dvec2(after.transform[2])), after.transform[2] == dvec2(0.0));
    if (before.used() && before.transform[0] == after.transform[0] && before.transform[1] == after.transform[1])
        return;
    const UvTransform transform = uvTransformOf(after.transform);
    put(json, place / "rotation", transform.rotation, transform.rotation == 0.0);
    put(json, place / "scale", numbers(transform.scale), transform.scale == dvec2(1.0));
}

void writeUse(OrderedJson& json, const Pointer& info, const TextureUse& before, const TextureUse& after)
{
    if (!after.used())
        return drop(json, info);
    if (before.texture != after.texture)
        json[info / "index"] = after.texture;
    const bool moved = !before.used() || before.transform != after.transform;
    if (!before.used() || before.uvSet != after.uvSet) {
        put(json, info / "texCoord", after.uvSet, after.uvSet == 0);
        drop(json, info / "extensions" / "KHR_texture_transform" / "texCoord"); // it would have the last word
    }
    if (moved)
        writeTransform(json, info, before, after);
}

void writeTextures(OrderedJson& json, const Material& before, const Material& after)
{
    const Pointer root;
    const Pointer pbr("/pbrMetallicRoughness");
    writeUse(json, pbr / "baseColorTexture", before.baseColor, after.baseColor);
    writeUse(json, pbr / "metallicRoughnessTexture", before.metallicRoughness, after.metallicRoughness);
    writeUse(json, root / "normalTexture", before.normal, after.normal);
    writeUse(json, root / "occlusionTexture", before.occlusion, after.occlusion);
    writeUse(json, root / "emissiveTexture", before.emissive, after.emissive);
    if (after.normal.used() && (!before.normal.used() || before.normalScale != after.normalScale))
        put(json, root / "normalTexture" / "scale", after.normalScale, after.normalScale == 1.0);
    if (after.occlusion.used() && (!before.occlusion.used() || before.occlusionStrength != after.occlusionStrength))
        put(json, root / "occlusionTexture" / "strength", after.occlusionStrength, after.occlusionStrength == 1.0);
}

} // namespace

void writeMaterial(OrderedJson& json, const Material& before, const Material& after)
{
    const Material plain;
    const auto putChanged = [&](const char* place, auto Material::*member, const auto& value) {
        if (before.*member != after.*member)
            put(json, Pointer(place), value, after.*member == plain.*member);
    };
    putChanged("/name", &Material::name, after.name);
    putChanged("/pbrMetallicRoughness/baseColorFactor", &Material::baseColorFactor, numbers(after.baseColorFactor));
    putChanged("/pbrMetallicRoughness/metallicFactor", &Material::metallicFactor, after.metallicFactor);
    putChanged("/pbrMetallicRoughness/roughnessFactor", &Material::roughnessFactor, after.roughnessFactor);
    if (before.emissiveFactor != after.emissiveFactor)
        writeEmissive(json, after.emissiveFactor);
    putChanged("/alphaMode", &Material::alphaMode, nameOf(after.alphaMode));
    putChanged("/alphaCutoff", &Material::alphaCutoff, after.alphaCutoff);
    putChanged("/doubleSided", &Material::doubleSided, after.doubleSided);
    putChanged("/extensions/KHR_materials_unlit", &Material::unlit, OrderedJson::object());
    putChanged("/extensions/KHR_materials_ior/ior", &Material::ior, after.ior);
    writeTextures(json, before, after);
}

} // namespace torrance
