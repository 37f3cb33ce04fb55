// A document with something of everything that a save must not touch, and what a saved file holds.
#pragma once

#include "gltf_builder.h"
#include "png_bytes.h"

#include "files/gltf_container.h"
#include "files/gltf_save.h"
#include "files/read_file.h"

#include <iterator>

namespace torrance::test {

inline std::vector<std::byte> pngOf(std::uint8_t red)
{
    PngSpec spec;
    spec.width = 2;
    spec.colorType = 2;
    spec.scanlines = {0, red, 0, 0, 255, 0, 255};
    const std::string png = pngBytes(spec);
    const auto* first = reinterpret_cast<const std::byte*>(png.data());
    return {first, first + png.size()};
}

/// Materials 0, not drawn, 1 with everything, and 2 with nothing; mesh 0 with material 1, which two nodes show, and
/// mesh 1 with material 2 and with none; two textures of one picture in the chunk; extensions and extras everywhere.
inline GltfBuilder richModel()
{
    using Json = nlohmann::json;
    GltfBuilder builder = GltfBuilder::triangle();
    const int uv = builder.addFloats({0, 0, 1, 0, 0, 1}, "VEC2");
    Json drawn = builder.primitive();
    drawn["attributes"]["TEXCOORD_0"] = drawn["attributes"]["TEXCOORD_1"] = uv;
    Json first = drawn, second = drawn;
    first["material"] = 1;
    first["extras"] = {{"kept", {1, 2.5, "three"}}};
    first["extensions"]["KHR_materials_variants"] = {{"mappings", {{{"material", 2}, {"variants", {0}}}}}};
    second["material"] = 2;
    builder.json["meshes"] = {{{"name", "twice"}, {"primitives", {first}}}, {{"primitives", {second, drawn}}}};
    builder.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {2, 0, 0}}}, {{"mesh", 1}}};
    builder.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
    builder.json["images"] = {{{"bufferView", builder.addView(pngOf(255))}, {"mimeType", "image/png"}}};
    builder.json["samplers"] = {{{"wrapS", 33071}, {"magFilter", 9728}, {"name", "edge"}}};
    builder.json["textures"] = {{{"source", 0}, {"name", "kept"}}, {{"source", 0}, {"sampler", 0}}};
    const Json transform = {{"offset", {0.1, 0.2}}, {"rotation", 0.3}, {"scale", {2, 0.7}}};
    builder.json["materials"] = {
        {{"name", "not drawn"}, {"extensions", {{"KHR_materials_unlit", Json::object()}}}},
        {{"name", "all"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
           {"metallicFactor", 0.5},
           {"roughnessFactor", 0.6},
           {"baseColorTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}},
           {"metallicRoughnessTexture", {{"index", 1}, {"texCoord", 1}, {"extras", "kept"}}}}},
         {"normalTexture", {{"index", 0}, {"scale", -2}}},
         {"occlusionTexture", {{"index", 0}, {"strength", 0.7}}},
         {"emissiveTexture", {{"index", 1}}},
         {"emissiveFactor", {0.5, 1, 0.25}},
         {"alphaMode", "MASK"},
         {"alphaCutoff", 0.75},
         {"doubleSided", true},
         {"extras", {{"author", "someone"}, {"deep", {{"er", Json::array()}}}}},
         {"extensions",
          {{"KHR_materials_clearcoat", {{"clearcoatFactor", 0.9}, {"clearcoatTexture", {{"index", 1}}}}},
           {"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}},
           {"KHR_materials_ior", {{"ior", 1.3}}}}}},
        Json::object()};
    builder.json["animations"] = {{{"channels", Json::array()}, {"samplers", Json::array()}}};
    builder.json["asset"] = {{"version", "2.0"}, {"copyright", "2026 someone"}, {"generator", "by hand"}};
    builder.json["extensions"] = {{"KHR_materials_variants", {{"variants", {{{"name", "other"}}}}}},
                                  {"EXT_nobody_knows", {{"numbers", {1, -1.5, 1e300, 12345678901234567890u}}}}};
    builder.json["extras"] = {{"view", {{"uri", "not ours"}}}};
    builder.json["extensionsUsed"] = {"KHR_texture_transform",  "EXT_nobody_knows",
                                      "KHR_materials_variants", "KHR_materials_clearcoat",
                                      "KHR_materials_unlit",    "KHR_materials_emissive_strength",
                                      "KHR_materials_ior"};
    builder.json["x"] = nullptr;
    builder.json["buffers"] = {{{"byteLength", builder.binary.size()}, {"name", "kept"}}};
    return builder;
}

struct SavedFile
{
    std::vector<std::byte> bytes;
    nlohmann::ordered_json json;
    std::vector<std::byte> binary;
    bool isBinary = false;
};

inline SavedFile readSaved(const std::filesystem::path& path)
{
    SavedFile saved;
    saved.bytes = readFile(path, path.string(), "");
    const GltfContainer container = splitContainer(saved.bytes, path.string());
    saved.json = nlohmann::ordered_json::parse(container.json);
    if (container.binary)
        saved.binary.assign(container.binary->begin(), container.binary->end());
    saved.isBinary = container.isBinary;
    return saved;
}

/// Where two documents differ, as JSON pointers.
inline std::vector<std::string> changedPlaces(const nlohmann::ordered_json& before, const nlohmann::ordered_json& after)
{
    std::vector<std::string> places;
    for (const auto& step : nlohmann::json::diff(nlohmann::json(before), nlohmann::json(after)))
        places.push_back(step["path"]);
    return places;
}

/// Each place lies at or below one of these, and each of these has one.
inline bool liesIn(const std::vector<std::string>& places, const std::vector<std::string>& expected)
{
    const auto below = [](const std::string& place, const std::string& of) {
        return place == of || place.starts_with(of + "/");
    };
    for (const std::string& place : places)
        if (std::none_of(expected.begin(), expected.end(), [&](const auto& of) { return below(place, of); }))
            return false;
    for (const std::string& of : expected)
        if (std::none_of(places.begin(), places.end(), [&](const auto& place) { return below(place, of); }))
            return false;
    return true;
}

inline std::string joined(const std::vector<std::string>& texts)
{
    std::string line;
    for (const std::string& text : texts)
        line += text + " ";
    return line;
}

/// What saving says, checked to be one line; empty where it succeeds.
inline std::string saveError(const std::filesystem::path& source, const Scene& original, const Scene& edited,
                             const std::filesystem::path& target, ExitCode code, const GltfSaveOptions& options = {})
{
    try {
        saveGltf(source, original, edited, target, options);
    } catch (const Error& error) {
        const std::string message = error.what();
        EXPECT_EQ(error.exitCode, code) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
        return message;
    }
    return "";
}

inline std::size_t filesIn(const std::filesystem::path& folder)
{
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

} // namespace torrance::test
