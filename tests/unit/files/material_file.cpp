// A material in a file of its own, and where two materials differ.
#include "files/material_file.h"

#include "gltf_save_cases.h"

#include "files/material_difference.h"

#include <functional>

namespace torrance {
namespace {

const std::pair<const char*, std::function<void(Material&)>> kChanges[] = {
    {"name", [](Material& m) { m.name = "\"brass\" \xc3\xa9"; }},
    {"baseColorFactor", [](Material& m) { m.baseColorFactor = dvec4(1.0 / 3.0, 0.1 + 0.2, 0.0, 0.5); }},
    {"metallicFactor", [](Material& m) { m.metallicFactor = 1.0 / 3.0; }},
    {"roughnessFactor", [](Material& m) { m.roughnessFactor = 1e-300; }},
    {"emissiveFactor", [](Material& m) { m.emissiveFactor = dvec3(1.0 / 3.0, 70.1, 4.3); }},
    {"alphaMode", [](Material& m) { m.alphaMode = AlphaMode::mask; }},
    {"alphaCutoff", [](Material& m) { m.alphaCutoff = 1.0 / 3.0; }},
    {"doubleSided", [](Material& m) { m.doubleSided = true; }},
    {"unlit", [](Material& m) { m.unlit = true; }},
    {"ior", [](Material& m) { m.ior = 4.0 / 3.0; }},
};

std::string messageOf(const std::function<void()>& action, ExitCode code)
{
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, code) << error.what();
        EXPECT_FALSE(contains(error.what(), "\n"));
        return error.what();
    }
    return "";
}

TEST(MaterialFile, HoldsEveryFactor)
{
    const TestFolder folder;
    Material all;
    for (const auto& [field, change] : kChanges) {
        Material material;
        change(material);
        change(all);
        EXPECT_EQ(differingField(material, Material{}), field);
        EXPECT_TRUE(saveMaterial(material, folder.path / "one.gltf").empty());
        const LoadedMaterial loaded = loadMaterial(folder.path / "one.gltf");
        EXPECT_EQ(differingField(loaded.material, material), "") << field;
        EXPECT_TRUE(loaded.warnings.empty()) << field;
    }
    saveMaterial(all, folder.path / "all.gltf");
    EXPECT_EQ(differingField(loadMaterial(folder.path / "all.gltf").material, all), "");
    EXPECT_EQ(test::filesIn(folder.path), 2u);
}

TEST(MaterialFile, IsAGltfDocument)
{
    const TestFolder folder;
    Material material;
    material.unlit = true;
    saveMaterial(material, folder.path / "m.gltf");
    EXPECT_EQ(errorOf(folder.path / "m.gltf"), "");
    const auto json = test::readSaved(folder.path / "m.gltf").json;
    EXPECT_EQ(json["asset"]["extras"]["torranceMaterial"], 1);
    EXPECT_EQ(json["extensionsUsed"].dump(), R"(["KHR_materials_unlit"])");
    saveMaterial(Material{}, folder.path / "plain.gltf");
    EXPECT_EQ(test::readSaved(folder.path / "plain.gltf").json["materials"].dump(), "[{}]");
}

TEST(MaterialFile, LeavesTexturesOutAndSaysSo)
{
    const TestFolder folder;
    Material material;
    material.baseColor.texture = 3;
    material.normal.texture = 4;
    material.normalScale = 2.0;
    material.occlusionStrength = 0.5;
    const std::vector<std::string> left = saveMaterial(material, folder.path / "m.gltf");
    ASSERT_EQ(left.size(), 4u) << test::joined(left);
    EXPECT_TRUE(contains(left[0], "m.gltf: baseColorTexture: is left out")) << left[0];
    EXPECT_EQ(differingField(loadMaterial(folder.path / "m.gltf").material, Material{}), "");

    GltfBuilder builder = test::richModel();
    builder.json["materials"] = {builder.json["materials"][1]};
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    builder.json["meshes"][1]["primitives"][0]["material"] = 0;
    const LoadedMaterial loaded = loadMaterial(folder.write("model.glb", builder.glb()));
    EXPECT_EQ(loaded.material.name, "all");
    EXPECT_EQ(loaded.material.ior, 1.3);
    EXPECT_FALSE(loaded.material.normal.used());
    EXPECT_EQ(loaded.material.normalScale, 1.0);
    EXPECT_TRUE(contains(test::joined(loaded.warnings), "normalTexture: is left out"));
}

TEST(MaterialFile, RefusesBadFiles)
{
    const TestFolder folder;
    const auto error = [&](const std::string& text) {
        const auto path = folder.write("m.gltf", text);
        const std::string message = messageOf([&] { loadMaterial(path); }, ExitCode::input);
        EXPECT_TRUE(message.starts_with(path.string())) << message;
        return message;
    };
    EXPECT_TRUE(contains(error(""), "is empty"));
    EXPECT_TRUE(contains(error("not json"), "neither a GLB nor glTF"));
    EXPECT_TRUE(contains(error("{\"asset\": "), "malformed"));
    EXPECT_TRUE(contains(error("{}"), "/asset"));
    const std::string asset = R"({"asset": {"version": "2.0"}, "materials": )";
    EXPECT_TRUE(contains(error(asset + "[]}"), "holds 0 materials where one is due"));
    EXPECT_TRUE(contains(error(asset + "[{}, {}]}"), "holds 2 materials"));
    EXPECT_TRUE(contains(error(asset + "[1]}"), "/materials/0: is not an object"));
    EXPECT_TRUE(contains(error(asset + R"([{"alphaMode": "GLASS"}]})"), "GLASS"));
    EXPECT_TRUE(contains(error(asset + R"([{"pbrMetallicRoughness": {"metallicFactor": "1"}}]})"), "metallicFactor"));
    for (const char* version : {"2", "0", "-1", "1.5", "\"1\"", "1e300"})
        EXPECT_TRUE(contains(error(R"({"asset": {"version": "2.0", "extras": {"torranceMaterial": )" +
                                   std::string(version) + R"(}}, "materials": [{}]})"),
                             "/asset/extras/torranceMaterial: is not a version from 1 to 1"))
            << version;
    EXPECT_TRUE(contains(messageOf([&] { loadMaterial(folder.path / "none"); }, ExitCode::input), "no such file"));
    EXPECT_TRUE(contains(messageOf([&] { loadMaterial(folder.path); }, ExitCode::input), "is a folder"));
}

TEST(MaterialFile, RefusesWhatWouldNotReadBack)
{
    const TestFolder folder;
    const auto path = folder.write("m.gltf", std::string("old"));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double value : {1.5, -1.0, nan, std::numeric_limits<double>::infinity()}) {
        Material material;
        material.roughnessFactor = value;
        EXPECT_TRUE(
            contains(messageOf([&] { saveMaterial(material, path); }, ExitCode::cannotWrite), "roughnessFactor"));
    }
    EXPECT_NE(messageOf([&] { saveMaterial({}, folder.path / "none/m.gltf"); }, ExitCode::cannotWrite), "");
    EXPECT_EQ(test::filesIn(folder.path), 1u);
    EXPECT_EQ(readFile(path, "", "").size(), 3u) << "what was there";
}

TEST(MaterialDifference, IsFoundInEveryUseOfATexture)
{
    for (const auto& [name, use] : kTextureUses) {
        Material a;
        (a.*use).texture = 1;
        Material b = a;
        EXPECT_EQ(differingField(a, b), "") << name;
        const auto differs = [&](const char* part) {
            EXPECT_TRUE(differingField(a, b).starts_with(name + std::string("/") + part)) << differingField(a, b);
            b = a;
        };
        (b.*use).texture = 0;
        differs("index");
        (b.*use).uvSet = 1;
        differs("texCoord");
        for (int column = 0; column < 3; ++column) {
            (b.*use).transform[column].y += 1e-12;
            differs("transform");
        }
        (b.*use).transform[0].x += 4.4e-16; // two epsilons, of the four of kUvTransformError
        EXPECT_EQ(differingField(a, b), "");
        (b.*use) = TextureUse{};
        (b.*use).uvSet = 1;
        EXPECT_EQ(differingField(Material{}, b), "") << "of no texture nothing counts";
    }
    Material a, b;
    b.normalScale = 2.0;
    b.occlusionStrength = 0.5;
    EXPECT_EQ(differingField(a, b), "");
    a.normal.texture = b.normal.texture = 0;
    EXPECT_EQ(differingField(a, b), "normalTexture/scale");
    b.normalScale = 1.0;
    a.occlusion.texture = b.occlusion.texture = 0;
    EXPECT_EQ(differingField(a, b), "occlusionTexture/strength");
}

} // namespace
} // namespace torrance
