#include "files/gltf_materials.h"

#include "files/gltf_model.h"
#include "files/uv_transform.h"

#include <algorithm>
#include <limits>
#include <set>

namespace torrance {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Reflectance at normal incidence is 1 to within 4e-6 beyond this, and a shader's floats stay finite.
constexpr double kMostIor = 1e6;

class MaterialReader
{
public:
    MaterialReader(const tinygltf::Material& from, const std::string& name, LoadReport& messages)
        : source(from), item(name), report(messages)
    {
    }

    GltfMaterial read()
    {
        GltfMaterial result;
        Material& material = result.material;
        const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
        material.name = source.name;
        for (int i = 0; i < 4; ++i)
            material.baseColorFactor[i] =
                clamped(pbr.baseColorFactor[static_cast<std::size_t>(i)], 1.0, "baseColorFactor");
        material.metallicFactor = clamped(pbr.metallicFactor, 1.0, "metallicFactor");
        material.roughnessFactor = clamped(pbr.roughnessFactor, 1.0, "roughnessFactor");
        material.normalScale = source.normalTexture.scale;
        material.occlusionStrength = clamped(source.occlusionTexture.strength, 1.0, "occlusionTexture/strength");
        for (int i = 0; i < 3; ++i)
            material.emissiveFactor[i] =
                clamped(source.emissiveFactor[static_cast<std::size_t>(i)], 1.0, "emissiveFactor") * emissiveStrength();
        material.alphaMode = alphaMode();
        material.alphaCutoff = clamped(source.alphaCutoff, kNoLimit, "alphaCutoff");
        material.doubleSided = source.doubleSided;
        material.unlit = source.extensions.contains("KHR_materials_unlit");
        material.ior = ior();
        readTextures(result);
        return result;
    }

private:
    double clamped(double value, double most, const char* factor)
    {
        if (value >= 0.0 && value <= most)
            return value;
        report.warn(item + "/" + factor,
                    most == kNoLimit ? "is negative and was set to 0" : "is outside 0 to 1 and was clamped");
        return std::min(std::max(value, 0.0), most);
    }

    double emissiveStrength()
    {
        const auto extension = source.extensions.find("KHR_materials_emissive_strength");
        if (extension == source.extensions.end() || !extension->second.Has("emissiveStrength"))
            return 1.0;
        return clamped(extension->second.Get("emissiveStrength").GetNumberAsDouble(), kNoLimit, "emissiveStrength");
    }

    /// KHR_materials_ior: at least 1, or 0 for a dielectric that reflects everything.
    double ior()
    {
        const auto extension = source.extensions.find("KHR_materials_ior");
        if (extension == source.extensions.end() || !extension->second.Has("ior"))
            return Material{}.ior;
        const double value = extension->second.Get("ior").GetNumberAsDouble();
        if (value == 0.0 || (value >= 1.0 && value <= kMostIor))
            return value;
        report.warn(item + "/ior", "is neither 0 nor in 1 to 1000000 and was clamped");
        return std::clamp(value, 1.0, kMostIor);
    }

    AlphaMode alphaMode() const
    {
        if (source.alphaMode == "OPAQUE")
            return AlphaMode::opaque;
        if (source.alphaMode == "MASK")
            return AlphaMode::mask;
        if (source.alphaMode == "BLEND")
            return AlphaMode::blend;
        report.fail(item, "has the unknown alphaMode \"" + source.alphaMode + "\"", "use OPAQUE, MASK or BLEND");
    }

    void readTextures(GltfMaterial& result)
    {
        Material& material = result.material;
        material.baseColor = textureUse(source.pbrMetallicRoughness.baseColorTexture);
        material.metallicRoughness = textureUse(source.pbrMetallicRoughness.metallicRoughnessTexture);
        material.normal = textureUse(source.normalTexture);
        material.occlusion = textureUse(source.occlusionTexture);
        material.emissive = textureUse(source.emissiveTexture);
        const std::array<TextureUse*, 5> uses = {&material.baseColor, &material.metallicRoughness, &material.normal,
                                                 &material.occlusion, &material.emissive};
        chooseUvSets(result, uses);
        for (TextureUse* use : uses)
            if (use->used()) {
                use->uvSet = use->uvSet == result.uvSets[0] ? 0 : 1;
                result.textured[static_cast<std::size_t>(use->uvSet)] = true;
            }
    }

    /// Sets 0 and 1 keep their places; others take the place that is free.
    void chooseUvSets(GltfMaterial& result, const std::array<TextureUse*, 5>& uses) const
    {
        std::set<int> sets;
        for (const TextureUse* use : uses)
            if (use->used())
                sets.insert(use->uvSet);
        if (sets.size() > 2)
            report.fail(item, "samples " + std::to_string(sets.size()) + " sets of texture coordinates",
                        "use at most two in one material");
        if (!sets.empty() && *sets.rbegin() > 1)
            result.uvSets = {*sets.begin(), sets.size() == 2 ? *sets.rbegin() : 1};
    }

    template <typename Info>
    static TextureUse textureUse(const Info& info)
    {
        TextureUse use;
        use.texture = info.index;
        use.uvSet = info.texCoord;
        const auto extension = info.extensions.find("KHR_texture_transform");
        if (info.index < 0 || extension == info.extensions.end())
            return use;
        const tinygltf::Value& transform = extension->second;
        if (transform.Has("texCoord"))
            use.uvSet = transform.Get("texCoord").GetNumberAsInt();
        UvTransform read;
        read.offset = pair(transform, "offset", read.offset);
        read.rotation = transform.Has("rotation") ? transform.Get("rotation").GetNumberAsDouble() : 0.0;
        read.scale = pair(transform, "scale", read.scale);
        use.transform = matrixOf(read);
        return use;
    }

    static dvec2 pair(const tinygltf::Value& object, const char* name, const dvec2& otherwise)
    {
        if (!object.Has(name))
            return otherwise;
        const tinygltf::Value& values = object.Get(name);
        return dvec2(values.Get(0).GetNumberAsDouble(), values.Get(1).GetNumberAsDouble());
    }

    const tinygltf::Material& source;
    std::string item;
    LoadReport& report;
};

} // namespace

GltfMaterial readMaterial(const tinygltf::Model& model, std::size_t index, LoadReport& report)
{
    return MaterialReader(model.materials[index], itemName("materials", index), report).read();
}

} // namespace torrance
