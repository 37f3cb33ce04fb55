// Folders of maps as free texture libraries publish them.
#include "files/map_folder.h"

#include "files/channel_pack.h"
#include "files/map_role.h"
#include "gltf_builder.h"
#include "pictures.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

using test::pngRow;

TEST(MapRole, NamesOfTheLibraries)
{
    const std::vector<std::pair<const char*, std::optional<MapRole>>> expected = {
        {"Metal032_1K_Color", MapRole::color},
        {"Metal032_1K-PNG_Color", MapRole::color},
        {"Metal032_1K-JPG_Roughness", MapRole::roughness},
        {"Metal032_2K_Metalness", MapRole::metallic},
        {"Metal032_1K_NormalGL", MapRole::normalGl},
        {"Metal032_1K_NormalDX", MapRole::normalDx},
        {"Metal032_1K_AmbientOcclusion", MapRole::occlusion},
        {"Metal032_1K_Displacement", MapRole::displacement},
        {"Fabric_1K_Opacity", MapRole::opacity},
        {"Lava_1K_Emission", MapRole::emission},
        {"metal_plate_diff_1k", MapRole::color},
        {"metal_plate_rough_4k", MapRole::roughness},
        {"rough_wood_nor_gl_1k", MapRole::normalGl},
        {"rough_wood_nor_dx_16k", MapRole::normalDx},
        {"metal_plate_metal_1k", MapRole::metallic},
        {"metal_plate_ao_1k", MapRole::occlusion},
        {"metal_plate_arm_1k", MapRole::armPacked},
        {"albedo", MapRole::color},
        {"Base Color", MapRole::color},
        {"base-color", MapRole::color},
        {"ROUGHNESS", MapRole::roughness},
        {"metallic", MapRole::metallic},
        {"normal", MapRole::normalGl},
        {"rust.height.16bit", MapRole::displacement},
        {"rough_wood_preview", std::nullopt},
        {"Metal032", std::nullopt},
        {"thumbnail", std::nullopt},
        {"1k", std::nullopt},
        {"", std::nullopt},
    };
    for (const auto& [stem, role] : expected)
        EXPECT_EQ(mapRole(stem), role) << stem;
}

class Maps : public testing::Test
{
protected:
    void SetUp() override
    {
        picture("M_1K_Color.png", 2, 8, {255, 128, 0, 1, 2, 3});
        picture("M_1K_Roughness.png", 0, 16, {30000, 30001});
    }
    void picture(const std::string& name, int colorType, int bits, std::initializer_list<int> codes)
    {
        folder.write(name, pngRow(colorType, bits, codes));
    }
    Material read(const MapFolderNeeds& needs = {})
    {
        scene = {};
        report = {};
        report.file = folder.path.string();
        return readMapFolder(folder.path, needs, limits, scene, report);
    }
    std::string error(const MapFolderNeeds& needs = {})
    {
        try {
            read(needs);
        } catch (const Error& error) {
            const std::string message = error.what();
            EXPECT_EQ(error.exitCode, ExitCode::input);
            EXPECT_TRUE(message.starts_with(report.file)) << message;
            EXPECT_TRUE(contains(message, "; ")) << "no remedy: " << message;
            return message;
        }
        return "";
    }
    const TextureImage& image(const TextureUse& use) const
    {
        return scene.images.at(
            static_cast<std::size_t>(scene.textures.at(static_cast<std::size_t>(use.texture)).image));
    }

    TestFolder folder;
    SceneLimits limits;
    Scene scene;
    LoadReport report;
};

TEST_F(Maps, SixteenBitsReachTheScene)
{
    picture("M_1K_Metalness.png", 0, 16, {65534, 65535});
    const Material m = read();
    EXPECT_EQ(m.metallicFactor, 1.0);
    EXPECT_EQ(m.roughnessFactor, 1.0);
    const TextureImage& packed = image(m.metallicRoughness);
    EXPECT_EQ(packed.format, TexelFormat::rgba16);
    EXPECT_DOUBLE_EQ(texelValue(packed, 0, 0, Channel::green), 30000 / 65535.0);
    EXPECT_DOUBLE_EQ(texelValue(packed, 1, 0, Channel::green), 30001 / 65535.0);
    EXPECT_DOUBLE_EQ(texelValue(packed, 0, 0, Channel::blue), 65534 / 65535.0);
    EXPECT_EQ(image(m.baseColor).format, TexelFormat::rgba8);
    EXPECT_TRUE(report.warnings.empty());
}

TEST_F(Maps, WithoutMetalnessItIsADielectric)
{
    EXPECT_EQ(read().metallicFactor, 0.0);
}

TEST_F(Maps, GreenOfDirectXIsTurnedRound)
{
    picture("M_1K_NormalDX.png", 2, 8, {10, 20, 30, 128, 0, 255});
    const TextureImage& normal = image(read().normal);
    EXPECT_EQ(texelValue(normal, 0, 0, Channel::red), 10 / 255.0);
    EXPECT_EQ(texelValue(normal, 0, 0, Channel::green), 235 / 255.0);
    EXPECT_EQ(texelValue(normal, 0, 0, Channel::blue), 30 / 255.0);
    EXPECT_EQ(texelValue(normal, 1, 0, Channel::green), 1.0);
    picture("M_1K_NormalGL.png", 2, 8, {10, 77, 30, 128, 0, 255});
    EXPECT_EQ(texelValue(image(read().normal), 0, 0, Channel::green), 77 / 255.0) << "taken where both are there";
}

TEST_F(Maps, PackedMapsFillWhatSeparateOnesLeave)
{
    picture("m_arm_1k.png", 2, 8, {10, 20, 30, 40, 50, 60});
    const Material m = read();
    EXPECT_DOUBLE_EQ(texelValue(image(m.metallicRoughness), 0, 0, Channel::green), 30000 / 65535.0);
    EXPECT_EQ(texelValue(image(m.metallicRoughness), 0, 0, Channel::blue), 30 / 255.0);
    EXPECT_EQ(texelValue(image(m.occlusion), 0, 0, Channel::red), 10 / 255.0);
}

TEST_F(Maps, OpacityOcclusionAndEmission)
{
    picture("M_1K_Opacity.png", 0, 8, {0, 255});
    picture("M_1K_AmbientOcclusion.png", 0, 8, {100, 200});
    picture("M_1K_Emission.png", 2, 8, {0, 0, 0, 9, 9, 9});
    const Material m = read();
    EXPECT_EQ(m.alphaMode, AlphaMode::mask);
    EXPECT_EQ(texelValue(image(m.baseColor), 0, 0, Channel::alpha), 0.0);
    EXPECT_EQ(texelValue(image(m.baseColor), 0, 0, Channel::green), 128 / 255.0);
    EXPECT_EQ(texelValue(image(m.occlusion), 1, 0, Channel::red), 200 / 255.0);
    EXPECT_EQ(m.emissiveFactor, dvec3(1.0));
    EXPECT_TRUE(m.emissive.used());
}

TEST_F(Maps, DisplacementIsLeftOutWithAWarning)
{
    folder.write("M_1K_Displacement.exr", std::string("any"));
    read();
    ASSERT_EQ(report.warnings.size(), 1u);
    EXPECT_TRUE(contains(report.warnings[0], "displacement"));
}

TEST_F(Maps, SmallerMapsOfTheSameProportionsFit)
{
    folder.write(
        "M_1K_Roughness.png",
        test::pngBytes(
            {.width = 4, .height = 2, .bitDepth = 8, .colorType = 0, .scanlines = {0, 1, 2, 3, 4, 0, 5, 6, 7, 8}}));
    const Material m = read();
    EXPECT_EQ(image(m.metallicRoughness).width, 4);
    EXPECT_EQ(image(m.baseColor).width, 2);
}

TEST_F(Maps, WhatIsWrongIsSaidInOneLine)
{
    picture("M_2K_Color.png", 2, 8, {255, 128, 0, 1, 2, 3});
    EXPECT_TRUE(contains(error(), "M_2K_Color.png: and M_1K_Color.png are both of colour"));
    std::filesystem::remove(folder.path / "M_2K_Color.png");

    picture("M_1K_Metalness.png", 0, 8, {1, 2, 3});
    EXPECT_TRUE(contains(error(), "differ in their proportions: 3x1 and 2x1; give all maps the same size"));
    folder.write("M_1K_Metalness.png", std::string("no picture"));
    EXPECT_TRUE(contains(error(), "M_1K_Metalness.png: the image is neither PNG nor JPEG nor WebP"));
    std::filesystem::remove(folder.path / "M_1K_Metalness.png");
    folder.write("M_1K_Metalness.tif", std::string("any"));
    EXPECT_TRUE(contains(error(), "M_1K_Metalness.tif: is neither PNG nor JPEG nor WebP; convert it to PNG"));
    std::filesystem::remove(folder.path / "M_1K_Metalness.tif");

    limits.texelBytes = 10;
    EXPECT_TRUE(contains(error(), "more than 10 bytes of texels"));
    limits = {};
    std::filesystem::remove(folder.path / "M_1K_Roughness.png");
    EXPECT_TRUE(contains(error(), "has no map of roughness; add ..._Roughness.png, or give --roughness"));
    EXPECT_EQ(error({.color = true, .roughness = false}), "");
    std::filesystem::remove(folder.path / "M_1K_Color.png");
    EXPECT_TRUE(contains(error(), "holds no map that is told by its name"));
    picture("roughness.png", 0, 8, {1, 2});
    EXPECT_TRUE(contains(error(), "has no map of colour; add ..._Color.png, or give --base-color"));
    EXPECT_EQ(error({.color = false, .roughness = true}), "");
}

TEST_F(Maps, AFolderThatIsNone)
{
    LoadReport own;
    own.file = "nowhere";
    EXPECT_THROW(readMapFolder("nowhere", {}, limits, scene, own), Error);
    EXPECT_THROW(readMapFolder(folder.path / "M_1K_Color.png", {}, limits, scene, own), Error);
}

} // namespace
} // namespace torrance
