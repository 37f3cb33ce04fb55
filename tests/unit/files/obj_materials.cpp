// Materials of MTL files, and Phong's parameters as physically based ones.
#include "files/channel_pack.h"
#include "files/mtl_material.h"
#include "gltf_builder.h"
#include "pictures.h"
#include "scene/phong.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

using test::pngRow;

const std::string kTriangle = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n";

class MtlFile : public testing::Test
{
protected:
    /// A triangle with material `m`, whose statements these are.
    LoadedScene load(const std::string& statements, const LoadOptions& options = {})
    {
        folder.write("m.mtl", "newmtl m\n" + statements);
        return loadScene(folder.write("model.obj", kTriangle), options);
    }
    Material material(const std::string& statements) { return load(statements).scene.materials.at(0); }

    /// Checked to be an input error in one line that names the MTL file.
    std::string error(const std::string& statements)
    {
        try {
            load(statements);
        } catch (const Error& error) {
            EXPECT_EQ(error.exitCode, ExitCode::input);
            EXPECT_TRUE(contains(error.what(), (folder.path / "m.mtl").string())) << error.what();
            EXPECT_FALSE(contains(error.what(), "\n"));
            EXPECT_TRUE(contains(error.what(), "; ")) << "no remedy: " << error.what();
            return error.what();
        }
        return "";
    }

    void picture(const std::string& name, int colorType, int bits, std::initializer_list<int> codes)
    {
        folder.write(name, pngRow(colorType, bits, codes));
    }

    TestFolder folder;
};

TEST_F(MtlFile, PhysicallyBasedKeysAreTakenAsTheyStand)
{
    const Material m = material("Kd 0.8 0.5 0.25\nPr 0.3\nPm 0.75\nKe 2 1 0\nNs 500\nKs 1 1 1\n");
    EXPECT_EQ(m.name, "m");
    EXPECT_EQ(vec4(m.baseColorFactor), vec4(0.8f, 0.5f, 0.25f, 1.0f));
    EXPECT_FLOAT_EQ(m.roughnessFactor, 0.3f);
    EXPECT_FLOAT_EQ(m.metallicFactor, 0.75f);
    EXPECT_EQ(vec3(m.emissiveFactor), vec3(2, 1, 0));
    EXPECT_EQ(m.alphaMode, AlphaMode::opaque);
}

TEST_F(MtlFile, PhongsKeysBecomeAMicrofacetDielectric)
{
    // Ns 6 is alpha^2 = 2 / (6 + 2) = 1/4, so r = sqrt(1/2).
    const Material m = material("Ka 1 1 1\nKd 0.5\nKs 0.5 0.5 0.5\nNs 6\nillum 2\n");
    EXPECT_EQ(m.baseColorFactor, dvec4(0.5, 0.5, 0.5, 1.0)) << "one number stands for three";
    EXPECT_NEAR(m.roughnessFactor, std::sqrt(0.5), 1e-12);
    EXPECT_EQ(m.metallicFactor, 0.0);
    EXPECT_EQ(material("Ks 0 0 0\nNs 6\n").roughnessFactor, 1.0) << "no highlight";
    EXPECT_EQ(material("Ks 1 1 1\nNs 6\nillum 1\n").roughnessFactor, 1.0) << "no highlight";
    EXPECT_EQ(material("Ks 1 1 1\n").roughnessFactor, 1.0) << "no exponent";
    EXPECT_EQ(material("Pm 1\nNs 6\n").metallicFactor, 1.0) << "key by key";
    EXPECT_EQ(material("Ni 2\n").ior, 2.0);
    EXPECT_EQ(material("Ni 1\n").ior, 1.5);
}

TEST_F(MtlFile, StatesNothingAndIsPlain)
{
    const Material m = material("");
    EXPECT_EQ(m.baseColorFactor, dvec4(dvec3(kPlainBaseColor), 1.0));
    EXPECT_EQ(m.roughnessFactor, 1.0);
    EXPECT_EQ(m.metallicFactor, 0.0);
    EXPECT_TRUE(m.doubleSided);
}

TEST_F(MtlFile, TheLastOfAKeyCountsWithItsOptions)
{
    picture("c.png", 2, 8, {255, 128, 0});
    const LoadedScene loaded = load("Kd 1 0 0\nmap_Kd -clamp on -s 2 2 c.png\nmap_Kd c.png\nKd 0 1 0\n");
    EXPECT_EQ(loaded.scene.materials[0].baseColorFactor.g, 1.0);
    EXPECT_EQ(loaded.scene.materials[0].baseColor.transform, TextureUse{}.transform);
    EXPECT_EQ(loaded.scene.textures.at(0).sampler, Sampler{});
}

TEST_F(MtlFile, OpacityBlends)
{
    EXPECT_EQ(material("d 0.25\n").baseColorFactor.a, 0.25);
    EXPECT_EQ(material("d 0.25\n").alphaMode, AlphaMode::blend);
    EXPECT_EQ(material("Tr 0.25\n").baseColorFactor.a, 0.75);
    EXPECT_EQ(material("Tr 1\nd 1\n").baseColorFactor.a, 1.0) << "d wins, whatever the order";
    EXPECT_EQ(material("d 1\nTr 1\n").alphaMode, AlphaMode::opaque);
    EXPECT_EQ(material("d -halo 0.5\n").baseColorFactor.a, 0.5);
}

TEST_F(MtlFile, ValuesOutOfRangeAreClampedWithAWarning)
{
    const LoadedScene loaded = load("Kd 2 -1 0.5\nPr 3\nNs -4\nd nan\n");
    EXPECT_EQ(vec4(loaded.scene.materials[0].baseColorFactor), vec4(1, 0, 0.5f, 0));
    EXPECT_EQ(loaded.scene.materials[0].roughnessFactor, 1.0);
    EXPECT_EQ(warningsAbout(loaded, "Kd outside 0 to 1"), 1);
    EXPECT_EQ(warningsAbout(loaded, "Pr outside 0 to 1"), 1);
    EXPECT_EQ(warningsAbout(loaded, "1 numbers that are NaN"), 1);
}

TEST_F(MtlFile, WhatIsNotDrawnIsSaid)
{
    const LoadedScene loaded =
        load("Ps 1\nPc 0.5\nPcr 0.1\naniso 1\ndisp d.png\nTf 1 1 1\nfoo 1\nKd xyz 1 1 1\nPs 0\n");
    for (const char* part : {"Pc (clear coat)", "aniso (anisotropy)", "disp, which is not drawn",
                             "Tf, which is not drawn", "unknown key foo", "Kd as xyz"})
        EXPECT_EQ(warningsAbout(loaded, part), 1) << part;
    EXPECT_EQ(warningsAbout(load("Ps 0\nPc 0\n"), "not drawn"), 0) << "nothing is lost";
}

TEST_F(MtlFile, MapsMultiplyTheirValues)
{
    picture("c.png", 2, 8, {255, 128, 0});
    const LoadedScene loaded = load("Kd 0.5 0.5 0.5\nmap_Kd c.png\nmap_Ke c.png\n");
    const Material& m = loaded.scene.materials[0];
    EXPECT_EQ(m.baseColorFactor.r, 0.5);
    EXPECT_EQ(m.emissiveFactor, dvec3(1.0)) << "1 where the value is missing";
    EXPECT_EQ(m.baseColor.texture, m.emissive.texture) << "one picture, one texture";
    EXPECT_EQ(loaded.scene.images.size(), 1u);
    EXPECT_EQ(m.alphaMode, AlphaMode::opaque);
    EXPECT_EQ(material("map_Kd c.png\n").baseColorFactor, dvec4(1.0));
}

TEST_F(MtlFile, RoughnessAndMetallicBecomeOneTexture)
{
    picture("r.png", 0, 16, {1000, 1001});
    picture("m.png", 0, 8, {0, 255});
    const LoadedScene loaded = load("map_Pr r.png\nmap_Pm m.png\nPr 0.5\n");
    const Material& m = loaded.scene.materials[0];
    ASSERT_TRUE(m.metallicRoughness.used());
    EXPECT_EQ(m.roughnessFactor, 0.5);
    EXPECT_EQ(m.metallicFactor, 1.0) << "the map alone";
    ASSERT_EQ(loaded.scene.images.size(), 1u);
    const TextureImage& image = loaded.scene.images[0];
    EXPECT_DOUBLE_EQ(texelValue(image, 0, 0, Channel::green), 1000 / 65535.0);
    EXPECT_DOUBLE_EQ(texelValue(image, 1, 0, Channel::green), 1001 / 65535.0);
    EXPECT_EQ(texelValue(image, 0, 0, Channel::blue), 0.0);
    EXPECT_EQ(texelValue(image, 1, 0, Channel::blue), 1.0);
}

TEST_F(MtlFile, OneMapOfTheTwoIsEnough)
{
    picture("r.png", 0, 8, {10, 20});
    const LoadedScene rough = load("map_Pr r.png\n");
    EXPECT_EQ(rough.scene.materials[0].metallicFactor, 0.0);
    EXPECT_EQ(texelValue(rough.scene.images.at(0), 1, 0, Channel::green), 20 / 255.0);
    const LoadedScene metal = load("map_Pm r.png\nNs 6\n");
    EXPECT_NEAR(metal.scene.materials[0].roughnessFactor, std::sqrt(0.5), 1e-12);
    EXPECT_EQ(texelValue(metal.scene.images.at(0), 1, 0, Channel::green), 1.0);
    EXPECT_EQ(texelValue(metal.scene.images.at(0), 1, 0, Channel::blue), 20 / 255.0);
}

TEST_F(MtlFile, ChannelsOfOnePictureAreNamed)
{
    picture("orm.png", 2, 8, {10, 20, 30});
    const LoadedScene loaded = load("map_Pr -imfchan g orm.png\nmap_Pm -imfchan b orm.png\n");
    const TextureImage& image = loaded.scene.images.at(0);
    EXPECT_EQ(texelValue(image, 0, 0, Channel::green), 20 / 255.0);
    EXPECT_EQ(texelValue(image, 0, 0, Channel::blue), 30 / 255.0);
}

TEST_F(MtlFile, AMapOfShininessBecomesRoughness)
{
    picture("s.png", 0, 8, {0, 255});
    const LoadedScene loaded = load("Ns 6\nKs 1 1 1\nmap_Ns s.png\n");
    const TextureImage& image = loaded.scene.images.at(0);
    EXPECT_EQ(loaded.scene.materials[0].roughnessFactor, 1.0);
    EXPECT_EQ(texelValue(image, 0, 0, Channel::green), 1.0);
    EXPECT_NEAR(texelValue(image, 1, 0, Channel::green), std::sqrt(0.5), 1.0 / 65535.0);
    EXPECT_EQ(warningsAbout(load("Pr 0.5\nmap_Ns s.png\n"), "map_Ns, which is not used"), 1);
    EXPECT_EQ(warningsAbout(load("map_Ns s.png\n"), "map_Ns, which is not used"), 1);
}

TEST_F(MtlFile, OpacityMapsGoIntoTheBaseColour)
{
    picture("c.png", 2, 8, {255, 128, 0, 1, 2, 3});
    picture("cutout.png", 0, 8, {0, 255});
    picture("soft.png", 0, 8, {100, 255});
    picture("rgba.png", 6, 8, {9, 9, 9, 77, 9, 9, 9, 255});
    const LoadedScene cut = load("map_Kd c.png\nmap_d cutout.png\n");
    EXPECT_EQ(cut.scene.materials[0].alphaMode, AlphaMode::mask);
    EXPECT_EQ(texelValue(cut.scene.images.at(0), 0, 0, Channel::alpha), 0.0);
    EXPECT_EQ(texelValue(cut.scene.images.at(0), 0, 0, Channel::green), 128 / 255.0);
    const LoadedScene soft = load("map_d soft.png\n");
    EXPECT_EQ(soft.scene.materials[0].alphaMode, AlphaMode::blend);
    EXPECT_EQ(texelValue(soft.scene.images.at(0), 0, 0, Channel::alpha), 100 / 255.0);
    EXPECT_EQ(texelValue(soft.scene.images.at(0), 0, 0, Channel::red), 1.0);
    const LoadedScene alpha = load("map_Kd rgba.png\nmap_d rgba.png\n");
    EXPECT_EQ(texelValue(alpha.scene.images.at(0), 0, 0, Channel::alpha), 77 / 255.0) << "alpha where there is one";
}

TEST_F(MtlFile, BumpMapsAreHeightsOrNormals)
{
    picture("h.png", 0, 8, {0, 51, 102, 153, 204, 255});
    picture("n.png", 2, 8, {128, 128, 255});
    const LoadedScene height = load("bump -bm 5 -clamp on h.png\n");
    EXPECT_EQ(height.scene.materials[0].normalScale, 1.0);
    EXPECT_NEAR(2.0 * texelValue(height.scene.images.at(0), 2, 0, Channel::red) - 1.0, -std::sqrt(0.5), 1e-4);
    const LoadedScene normal = load("map_Bump -bm 0.5 n.png\n");
    EXPECT_EQ(normal.scene.materials[0].normalScale, 0.5);
    EXPECT_EQ(texelValue(normal.scene.images.at(0), 0, 0, Channel::red), 128 / 255.0);
    const LoadedScene both = load("map_bump h.png\nnorm n.png\n");
    EXPECT_EQ(warningsAbout(both, "map_bump, which is not used: norm is there"), 1);
    EXPECT_EQ(both.scene.images.size(), 1u);
}

TEST_F(MtlFile, CoordinatesAreScaledAndMovedWhereVRunsUp)
{
    picture("c.png", 2, 8, {255, 128, 0});
    for (const char* options : {"-s 2 3 -o 0.25 0.5", "-o 0.25 0.5 0 -s 2 3 1", "-s 2 3 -o 0.25 0.5 -clamp off"}) {
        const TextureUse use = material(std::string("map_Kd ") + options + " c.png\n").baseColor;
        // (u, v) = (0.1, 0.7), v up: (2 * 0.1 + 0.25, 3 * 0.7 + 0.5) = (0.45, 2.6), v down: -1.6.
        const dvec2 at = use.transform * dvec3(0.1, 1.0 - 0.7, 1.0);
        EXPECT_NEAR(at.x, 0.45, 1e-6) << options;
        EXPECT_NEAR(at.y, -1.6, 1e-6) << options;
    }
    EXPECT_EQ(material("map_Kd -s 2 c.png\n").baseColor.transform[1].y, 1.0) << "v stays where u alone is scaled";
}

TEST_F(MtlFile, OptionsAreFollowedOrWarnedOf)
{
    picture("c.png", 2, 8, {255, 128, 0});
    const LoadedScene loaded = load("map_Kd -clamp on -t 1 1 1 -mm 0.1 0.9 -blendu off -boost 2 -texres 64 -bm 2 -type "
                                    "sphere -colorspace linear -imfchan r c.png\n");
    EXPECT_EQ(loaded.scene.textures.at(0).sampler.wrapS, Wrap::clampToEdge);
    for (const char* option : {"-t", "-mm", "-blendu", "-boost", "-texres", "-bm", "-type", "-colorspace", "-imfchan"})
        EXPECT_EQ(warningsAbout(loaded, "map_Kd " + std::string(option) + ", which is not followed"), 1) << option;
    EXPECT_TRUE(load("map_Kd -t 0 0 0 -mm 0 1 -blendu on -s 1 1 1 c.png\n").warnings.empty()) << "nothing is lost";
    EXPECT_TRUE(contains(error("map_Kd -foo 1 c.png\n"), "line 2: \"-foo\" is no option of a map"));
}

TEST_F(MtlFile, NamesMayHoldSpacesAndFolders)
{
    picture("my maps/the color.png", 2, 8, {255, 128, 0});
    EXPECT_TRUE(material("map_Kd my maps\\the color.png\n").baseColor.used());
    EXPECT_TRUE(material("map_Kd -s 2 2 2 my maps/the color.png\n").baseColor.used());
}

TEST_F(MtlFile, MissingMapsAreErrors)
{
    const std::string missing = error("Kd 1 1 1\nmap_Kd gone.png\n");
    EXPECT_TRUE(contains(missing, "material m: map_Kd (gone.png): no such file; check the name")) << missing;
    folder.write("broken.png", std::string("\x89PNG\r\n\x1a\nxx"));
    EXPECT_TRUE(contains(error("map_Pr broken.png\n"), "material m: map_Pr (broken.png)"));
    EXPECT_TRUE(contains(error("map_Kd ../c.png\n"), "outside its folder"));
    EXPECT_TRUE(contains(error("map_Kd C:\\maps\\c.png\n"), "outside its folder"));
    EXPECT_TRUE(contains(error("map_Kd\n"), "line 2: map_Kd names no file"));
    EXPECT_TRUE(contains(error("Kd red\n"), "line 2: \"red\" is no number"));
}

TEST_F(MtlFile, MapsOfOneTextureMustFit)
{
    picture("a.png", 0, 8, {1, 2});
    picture("b.png", 0, 8, {1, 2, 3});
    EXPECT_TRUE(contains(error("map_Pr a.png\nmap_Pm b.png\n"), "3x1 and 2x1; give both the same size"));
    EXPECT_TRUE(contains(error("map_Pr a.png\nmap_Pm -s 2 2 a.png\n"), "give both the same -s, -o and -clamp"));
}

TEST_F(MtlFile, OnlyWhatIsDrawnIsRead)
{
    const LoadedScene loaded = load("Kd 1 0 0\nnewmtl unused\nmap_Kd gone.png\n");
    EXPECT_EQ(loaded.scene.materials.size(), 1u);
}

TEST_F(MtlFile, AMissingLibraryIsAWarning)
{
    const LoadedScene loaded = loadScene(folder.write("model.obj", kTriangle));
    EXPECT_EQ(warningsAbout(loaded, "mtllib m.mtl: there is no such file"), 1);
    EXPECT_EQ(loaded.scene.materials.at(0).baseColorFactor.r, kPlainBaseColor);
    folder.write("m.mtl", std::string("newmtl other\nKd 1 0 0\n"));
    EXPECT_EQ(warningsAbout(loadScene(folder.path / "model.obj"), "usemtl m: no MTL file defines it"), 1);
}

TEST_F(MtlFile, LibrariesWithSpacesAndSeveralOfThem)
{
    folder.write("my m.mtl", std::string("newmtl m\nKd 1 0 0\n"));
    std::string text = kTriangle;
    text.replace(0, 12, "mtllib my m.mtl");
    EXPECT_EQ(loadScene(folder.write("model.obj", text)).scene.materials.at(0).baseColorFactor.g, 0.0);
    folder.write("a.mtl", std::string("newmtl a\nKd 1 0 0\n"));
    folder.write("b.mtl", std::string("newmtl m\nKd 0 1 0\n"));
    text.replace(0, 15, "mtllib a.mtl b.mtl");
    EXPECT_EQ(loadScene(folder.write("model.obj", text)).scene.materials.at(0).baseColorFactor.r, 0.0);
}

} // namespace
} // namespace torrance
