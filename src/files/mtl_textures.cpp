#include "files/mtl_textures.h"

#include "core/cancelled.h"
#include "files/encoded_image.h"
#include "files/height_map.h"
#include "files/material_maps.h"
#include "files/mtl_options.h"
#include "files/read_file.h"
#include "files/sibling_path.h"
#include "scene/phong.h"

#include <map>
#include <optional>

namespace torrance {
namespace {

class MtlTextureReader
{
public:
    MtlTextureReader(const LoadOptions& asked, Scene& target, LoadReport& messages)
        : options(asked), scene(target), report(messages)
    {
    }

    void read(const std::vector<MtlPair>& materials)
    {
        for (const MtlPair& pair : materials)
            for (const MtlMapKey& key : kMtlMapKeys)
                if (isUsed(*pair.from, key))
                    openSource(*pair.from, key);
        checkTotalSize(encoded, options.limits.texelBytes);
        sources = decodeAll(encoded, options.stop);
        imageOfSource.assign(sources.size(), -1);
        for (const MtlPair& pair : materials) {
            material = pair.from;
            setBaseColor(*pair.to);
            setMetallicRoughness(*pair.to);
            setNormal(*pair.to);
            if (material->has("map_Ke"))
                pair.to->emissive = use("map_Ke", rawImage("map_Ke"));
        }
        for (std::size_t i = 0; i < sources.size(); ++i)
            if (imageOfSource[i] >= 0)
                scene.images[static_cast<std::size_t>(imageOfSource[i])] = std::move(sources[i]);
    }

private:
    std::string itemOf(const MtlMaterial& of, std::string_view key) const
    {
        return "material " + of.name + ": " + std::string(key);
    }

    [[noreturn]] void fail(std::string_view key, const std::string& problem, const char* remedy) const
    {
        throw inputError(material->file, itemOf(*material, key), problem, remedy);
    }

    bool isUsed(const MtlMaterial& of, const MtlMapKey& key)
    {
        if (!of.has(std::string(key.name)))
            return false;
        const std::string reason = passedOver(of, key.name);
        if (!reason.empty())
            report.warn("material " + of.name, "has " + std::string(key.name) + ", which is not used: " + reason);
        return reason.empty();
    }

    /// Why a map that is there is not used; empty where it is.
    static std::string passedOver(const MtlMaterial& of, std::string_view key)
    {
        if (key == "map_Ns" && (of.has("Pr") || of.has("map_Pr")))
            return "Pr is there";
        if (key == "map_Ns" && !of.has("Ns"))
            return "it multiplies Ns, which is missing";
        if (key == "map_bump" && of.has("norm"))
            return "norm is there";
        return "";
    }

    /// The picture of a key, read but not decoded; the same file is read once, whoever names it.
    void openSource(const MtlMaterial& of, const MtlMapKey& key)
    {
        const std::string& name = of.values.*key.file;
        const std::string item = itemOf(of, key.name) + " (" + name + ")";
        warnOfOptions(of, key, report);
        const std::filesystem::path folder = std::filesystem::path(of.file).parent_path();
        const std::filesystem::path path = siblingPath(name, folder, options.allowExternal, of.file, item);
        const auto [source, isNew] = sourceOfPath.try_emplace(path, encoded.size());
        sourceOfMap[{&of, key.name}] = source->second;
        if (!isNew)
            return;
        endWhereStopped(options.stop);
        EncodedImage image;
        image.file = of.file;
        image.name = item;
        image.storage = readFile(path, of.file, item);
        encodedBytes += image.storage.size();
        encoded.push_back(std::move(image));
        encoded.back().bytes = encoded.back().storage;
        if (encodedBytes > kMaxFileBytes)
            throw inputError(of.file, item, "brings the images of the file to more than 4 GiB", "use smaller images");
    }

    const TextureImage* image(std::string_view key) const
    {
        const auto source = sourceOfMap.find({material, key});
        return source == sourceOfMap.end() ? nullptr : &sources[source->second];
    }

    const tinyobj::texture_option_t& optionsOf(std::string_view key) const
    {
        return material->values.*mtlMapKey(key).options;
    }

    TextureUse use(std::string_view key, int imageNumber)
    {
        const tinyobj::texture_option_t& asked = optionsOf(key);
        const auto [texture, isNew] = textures.try_emplace({imageNumber, asked.clamp}, scene.textures.size());
        if (isNew) {
            Sampler sampler;
            if (asked.clamp)
                sampler.wrapS = sampler.wrapT = Wrap::clampToEdge;
            scene.textures.push_back({imageNumber, sampler});
        }
        TextureUse result;
        result.texture = static_cast<int>(texture->second);
        result.transform = mtlTransform(asked);
        return result;
    }

    int rawImage(std::string_view key)
    {
        int& number = imageOfSource[sourceOfMap.at({material, key})];
        if (number < 0)
            number = addImage({});
        return number;
    }

    int addImage(TextureImage added)
    {
        scene.images.push_back(std::move(added));
        return static_cast<int>(scene.images.size()) - 1;
    }

    /// Pictures that are made are made once for the materials that ask for the same.
    template <typename Make>
    int madeImage(const std::string& recipe, Make&& make)
    {
        const auto [entry, isNew] = made.try_emplace(recipe, 0);
        if (isNew)
            entry->second = addImage(make());
        return entry->second;
    }

    std::string recipe(std::string_view key) const
    {
        const tinyobj::texture_option_t& asked = optionsOf(key);
        return image(key) == nullptr
                   ? std::string("-")
                   : std::to_string(sourceOfMap.at({material, key})) + asked.imfchan + (asked.clamp ? "c" : "r");
    }

    Wrap wrapOf(std::string_view key) const { return optionsOf(key).clamp ? Wrap::clampToEdge : Wrap::repeat; }

    /// Both sample one texture: they must agree in how, and in their pictures' proportions.
    void checkPair(std::string_view first, std::string_view second) const
    {
        if (image(first) == nullptr || image(second) == nullptr)
            return;
        const tinyobj::texture_option_t &a = optionsOf(first), &b = optionsOf(second);
        const std::string both = "shares a texture with " + std::string(first);
        if (mtlTransform(a) != mtlTransform(b) || a.clamp != b.clamp)
            fail(second, both + ", which has other options", "give both the same -s, -o and -clamp");
        if (differInProportions(*image(second), *image(first)))
            fail(second, both + " of other proportions: " + sizesText(*image(second), *image(first)),
                 "give both the same size");
    }

    void setBaseColor(Material& to)
    {
        const TextureImage* color = image("map_Kd");
        const TextureImage* opacity = image("map_d");
        if (opacity == nullptr) {
            if (color != nullptr)
                to.baseColor = use("map_Kd", rawImage("map_Kd"));
            return;
        }
        checkPair("map_Kd", "map_d");
        const int packed = madeImage("color " + recipe("map_Kd") + recipe("map_d"), [&] {
            const Channel channel = mtlChannel(optionsOf("map_d"), opacityChannel(*opacity));
            return packColorOpacity(color, {opacity, channel}, wrapOf("map_d"));
        });
        to.baseColor = use(color == nullptr ? "map_d" : "map_Kd", packed);
        if (to.alphaMode == AlphaMode::opaque)
            to.alphaMode =
                isCutOut(scene.images[static_cast<std::size_t>(packed)]) ? AlphaMode::mask : AlphaMode::blend;
    }

    void setMetallicRoughness(Material& to)
    {
        const bool fromShininess = image("map_Ns") != nullptr;
        const std::string_view roughnessKey = fromShininess ? "map_Ns" : "map_Pr";
        const TextureImage* roughness = image(roughnessKey);
        const TextureImage* metallic = image("map_Pm");
        if (roughness == nullptr && metallic == nullptr)
            return;
        checkPair(roughnessKey, "map_Pm");
        const std::string_view key = roughness != nullptr ? roughnessKey : "map_Pm";
        const double shininess = material->values.shininess;
        const std::string name =
            "rough " + recipe(roughnessKey) + recipe("map_Pm") + (fromShininess ? std::to_string(shininess) : "");
        to.metallicRoughness =
            use(key, madeImage(name, [&] {
                    MapChannel shine{roughness, mtlChannel(optionsOf(roughnessKey), Channel::luminance)};
                    if (fromShininess)
                        shine.change = [shininess](double value) {
                            return perceptualRoughnessOfShininess(shininess * value);
                        };
                    return packMetallicRoughness(shine, {metallic, mtlChannel(optionsOf("map_Pm"), Channel::luminance)},
                                                 wrapOf(key));
                }));
    }

    void setNormal(Material& to)
    {
        const std::string_view key = material->has("norm") ? "norm" : "map_bump";
        const TextureImage* map = image(key);
        if (map == nullptr)
            return;
        const tinyobj::texture_option_t& asked = optionsOf(key);
        const bool isHeight = key == "map_bump" && (asked.imfchan != 'l' || isGrey(*map));
        if (!isHeight) {
            to.normal = use(key, rawImage(key));
            to.normalScale = asked.bump_multiplier;
            return;
        }
        const std::string name = "height " + recipe(key) + std::to_string(asked.bump_multiplier);
        to.normal = use(key, madeImage(name, [&] {
                            return normalsOfHeights(*map, mtlChannel(asked, Channel::luminance), asked.bump_multiplier,
                                                    wrapOf(key));
                        }));
    }

    const LoadOptions& options;
    Scene& scene;
    LoadReport& report;
    const MtlMaterial* material = nullptr; // whose textures are made
    std::map<std::filesystem::path, std::size_t> sourceOfPath;
    std::map<std::pair<const MtlMaterial*, std::string_view>, std::size_t> sourceOfMap;
    std::vector<EncodedImage> encoded;
    std::uint64_t encodedBytes = 0;
    std::vector<TextureImage> sources;
    std::vector<int> imageOfSource; // scene's images that are a source as it is
    std::map<std::string, int> made;
    std::map<std::pair<int, bool>, std::size_t> textures; // of image and clamping
};

} // namespace

void readMtlTextures(const std::vector<MtlPair>& materials, const LoadOptions& options, Scene& scene,
                     LoadReport& report)
{
    MtlTextureReader(options, scene, report).read(materials);
}

} // namespace torrance
