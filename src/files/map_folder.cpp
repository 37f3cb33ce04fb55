#include "files/map_folder.h"

#include "files/encoded_image.h"
#include "files/map_role.h"
#include "files/material_maps.h"
#include "files/read_file.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace torrance {
namespace {

namespace fs = std::filesystem;

std::string smallExtension(const fs::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

class MapFolderReader
{
public:
    MapFolderReader(const fs::path& path, const SceneLimits& most, Scene& target, LoadReport& messages)
        : folder(path), limits(most), scene(target), report(messages)
    {
    }

    Material read(const MapFolderNeeds& needs)
    {
        findMaps();
        settleRoles(needs);
        decode();
        checkProportions();
        Material material;
        material.name = folder.filename().string();
        setColor(material);
        setMetallicRoughness(material);
        setNormal(material);
        setOcclusion(material);
        if (image(MapRole::emission) != nullptr) {
            material.emissiveFactor = dvec3(1.0);
            material.emissive.texture = addTexture(*image(MapRole::emission));
        }
        return material;
    }

private:
    /// In the order of their names, whatever order the folder has them in.
    std::vector<fs::path> filesByName() const
    {
        std::error_code failure;
        std::vector<fs::path> files;
        for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure))
            files.push_back(entry->path());
        if (failure)
            report.fail("", failure.message(), "name a folder of maps");
        std::sort(files.begin(), files.end());
        return files;
    }

    void findMaps()
    {
        for (const fs::path& file : filesByName()) {
            const auto role = mapRole(file.stem().string());
            const std::string extension = smallExtension(file);
            const bool isPicture =
                extension == ".png" || extension == ".jpg" || extension == ".jpeg" || extension == ".webp";
            if (!role || (!isPicture && extension != ".exr" && extension != ".tif" && extension != ".tiff" &&
                          extension != ".tga"))
                continue;
            if (isPicture)
                addMap(*role, file);
            else
                others.emplace(*role, file);
        }
    }

    void addMap(MapRole role, const fs::path& file)
    {
        const auto [entry, isNew] = maps.emplace(role, file);
        if (!isNew)
            report.fail(file.filename().string(),
                        "and " + entry->second.filename().string() + " are both of " + std::string(roleName(role)),
                        "leave one of them in the folder");
    }

    /// What is not used goes; what is needed must be there.
    void settleRoles(const MapFolderNeeds& needs)
    {
        if (maps.contains(MapRole::displacement) || others.contains(MapRole::displacement))
            report.warn("", "has a map of displacement, which is not used");
        maps.erase(MapRole::displacement);
        others.erase(MapRole::displacement);
        if (maps.contains(MapRole::normalGl))
            maps.erase(MapRole::normalDx);
        for (const auto& [role, file] : others) // a format that is not read, and nothing to take in its place
            if (!maps.contains(role))
                report.fail(file.filename().string(), "is neither PNG nor JPEG nor WebP", "convert it to PNG");
        if (maps.empty())
            report.fail("", "holds no map that is told by its name",
                        "name the pictures ..._Color, ..._Roughness, ..._Metalness, ..._NormalGL");
        if (needs.color && !maps.contains(MapRole::color))
            report.fail("", "has no map of colour", "add ..._Color.png, or give --base-color");
        if (needs.roughness && !maps.contains(MapRole::roughness) && !maps.contains(MapRole::armPacked))
            report.fail("", "has no map of roughness", "add ..._Roughness.png, or give --roughness");
    }

    void decode()
    {
        std::vector<EncodedImage> encoded;
        std::vector<MapRole> roles;
        for (const auto& [role, file] : maps) {
            EncodedImage added;
            added.file = report.file;
            added.name = file.filename().string();
            added.storage = readFile(file, added.file, added.name);
            encoded.push_back(std::move(added));
            encoded.back().bytes = encoded.back().storage;
            roles.push_back(role);
        }
        checkTotalSize(encoded, limits.texelBytes);
        std::vector<TextureImage> decoded = decodeAll(encoded);
        for (std::size_t i = 0; i < roles.size(); ++i)
            images.emplace(roles[i], std::move(decoded[i]));
    }

    void checkProportions() const
    {
        const TextureImage& first = images.begin()->second;
        for (const auto& [role, map] : images)
            if (differInProportions(first, map))
                report.fail(map.name, "and " + first.name + " differ in their proportions: " + sizesText(map, first),
                            "give all maps the same size");
    }

    const TextureImage* image(MapRole role) const
    {
        const auto found = images.find(role);
        return found == images.end() ? nullptr : &found->second;
    }

    int addTexture(TextureImage added)
    {
        scene.textures.push_back({static_cast<int>(scene.images.size()), Sampler{}});
        scene.images.push_back(std::move(added));
        return static_cast<int>(scene.textures.size()) - 1;
    }

    void setColor(Material& material)
    {
        const TextureImage* color = image(MapRole::color);
        const TextureImage* opacity = image(MapRole::opacity);
        if (opacity != nullptr) {
            material.baseColor.texture =
                addTexture(packColorOpacity(color, {opacity, opacityChannel(*opacity)}, Wrap::repeat));
            material.alphaMode = isCutOut(scene.images.back()) ? AlphaMode::mask : AlphaMode::blend;
        } else if (color != nullptr)
            material.baseColor.texture = addTexture(*color);
    }

    /// A channel of the map of this role, or of the packed one.
    MapChannel channelOf(MapRole role, Channel packed) const
    {
        if (image(role) != nullptr)
            return {image(role), Channel::luminance};
        return {image(MapRole::armPacked), packed};
    }

    void setMetallicRoughness(Material& material)
    {
        const MapChannel roughness = channelOf(MapRole::roughness, Channel::green);
        const MapChannel metallic = channelOf(MapRole::metallic, Channel::blue);
        material.metallicFactor = metallic.image == nullptr ? 0.0 : 1.0;
        if (roughness.image != nullptr || metallic.image != nullptr)
            material.metallicRoughness.texture = addTexture(packMetallicRoughness(roughness, metallic, Wrap::repeat));
    }

    void setNormal(Material& material)
    {
        if (const TextureImage* gl = image(MapRole::normalGl))
            material.normal.texture = addTexture(*gl);
        else if (const TextureImage* dx = image(MapRole::normalDx))
            material.normal.texture = addTexture(packChannels(dx->name,
                                                              {PackedChannel{dx, Channel::red},
                                                               {dx, Channel::green, 1.0, {}, false, true},
                                                               {dx, Channel::blue},
                                                               PackedChannel{}},
                                                              Wrap::repeat));
    }

    void setOcclusion(Material& material)
    {
        if (const TextureImage* own = image(MapRole::occlusion))
            material.occlusion.texture = addTexture(*own);
        else if (const TextureImage* packed = image(MapRole::armPacked))
            material.occlusion.texture = addTexture(*packed);
    }

    const fs::path folder;
    const SceneLimits& limits;
    Scene& scene;
    LoadReport& report;
    std::map<MapRole, fs::path> maps;
    std::map<MapRole, fs::path> others; // of formats that are not read
    std::map<MapRole, TextureImage> images;
};

} // namespace

Material readMapFolder(const fs::path& folder, const MapFolderNeeds& needs, const SceneLimits& limits, Scene& scene,
                       LoadReport& report)
{
    std::error_code failure;
    if (!fs::is_directory(folder, failure))
        report.fail("", fs::exists(folder, failure) ? "is no folder" : "no such folder", "name a folder of maps");
    return MapFolderReader(folder, limits, scene, report).read(needs);
}

} // namespace torrance
