// Materials, textures, samplers, images, and the extensions that belong to them.
#include "gltf_builder.h"
#include "png_bytes.h"

#include <cmath>

namespace torrance {
namespace {

/// Two texels of one row: red, and green of half alpha.
std::vector<std::byte> twoTexels()
{
    test::PngSpec spec;
    spec.width = 2;
    spec.scanlines = {0, 255, 0, 0, 255, 0, 255, 0, 128};
    const std::string png = test::pngBytes(spec);
    const auto* first = reinterpret_cast<const std::byte*>(png.data());
    return {first, first + png.size()};
}

/// A triangle with a material whose base colour texture lies in the GLB.
GltfBuilder textured()
{
    GltfBuilder builder = GltfBuilder::triangle();
    const int uv = builder.addFloats({0, 0, 1, 0, 0, 1}, "VEC2");
    builder.primitive()["attributes"]["TEXCOORD_0"] = uv;
    builder.primitive()["material"] = 0;
    builder.json["images"] = {{{"bufferView", builder.addView(twoTexels())}, {"mimeType", "image/png"}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    return builder;
}

nlohmann::json& baseColorTexture(GltfBuilder& builder)
{
    return builder.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
}

TEST(GltfMaterials, HaveTheDefaultsOfGltf)
{
    GltfBuilder builder = GltfBuilder::triangle();
    EXPECT_EQ(load(builder).scene.primitives.at(0).material, -1);
    EXPECT_TRUE(load(builder).scene.materials.empty());
    builder.primitive()["material"] = 0;
    builder.json["materials"] = {nlohmann::json::object()};
    const Material material = load(builder).scene.materials.at(0);
    EXPECT_EQ(material.baseColorFactor, dvec4(1.0));
    EXPECT_EQ(material.metallicFactor, 1.0);
    EXPECT_EQ(material.roughnessFactor, 1.0);
    EXPECT_EQ(material.normalScale, 1.0);
    EXPECT_EQ(material.occlusionStrength, 1.0);
    EXPECT_EQ(material.emissiveFactor, dvec3(0.0));
    EXPECT_EQ(material.alphaMode, AlphaMode::opaque);
    EXPECT_EQ(material.alphaCutoff, 0.5);
    EXPECT_FALSE(material.doubleSided);
    EXPECT_FALSE(material.unlit);
    EXPECT_FALSE(material.baseColor.used());
}

TEST(GltfMaterials, ReadEveryProperty)
{
    GltfBuilder builder = textured();
    builder.json["textures"] = nlohmann::json::array_t(5, {{"source", 0}});
    builder.primitive()["attributes"]["TEXCOORD_1"] = builder.addFloats({0, 0, 1, 0, 0, 1}, "VEC2");
    builder.json["materials"] = {{{"name", "all"},
                                  {"pbrMetallicRoughness",
                                   {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                                    {"metallicFactor", 0.5},
                                    {"roughnessFactor", 0.6},
                                    {"baseColorTexture", {{"index", 4}}},
                                    {"metallicRoughnessTexture", {{"index", 3}, {"texCoord", 1}}}}},
                                  {"normalTexture", {{"index", 2}, {"scale", -2}}},
                                  {"occlusionTexture", {{"index", 1}, {"strength", 0.7}, {"texCoord", 1}}},
                                  {"emissiveTexture", {{"index", 0}}},
                                  {"emissiveFactor", {0.5, 1, 0.25}},
                                  {"alphaMode", "MASK"},
                                  {"alphaCutoff", 0.75},
                                  {"doubleSided", true},
                                  {"extensions",
                                   {{"KHR_materials_unlit", nlohmann::json::object()},
                                    {"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}}};
    const Scene scene = load(builder).scene;
    const Material& material = scene.materials.at(0);
    EXPECT_EQ(material.name, "all");
    EXPECT_EQ(material.baseColorFactor, dvec4(0.1, 0.2, 0.3, 0.4));
    EXPECT_EQ(material.metallicFactor, 0.5);
    EXPECT_EQ(material.roughnessFactor, 0.6);
    EXPECT_EQ(material.normalScale, -2.0);
    EXPECT_EQ(material.occlusionStrength, 0.7);
    EXPECT_EQ(material.emissiveFactor, dvec3(2, 4, 1)) << "times the strength";
    EXPECT_EQ(material.alphaMode, AlphaMode::mask);
    EXPECT_EQ(material.alphaCutoff, 0.75);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_TRUE(material.unlit);
    EXPECT_EQ(material.baseColor.texture, 4);
    EXPECT_EQ(material.metallicRoughness.texture, 3);
    EXPECT_EQ(material.metallicRoughness.uvSet, 1);
    EXPECT_EQ(material.normal.texture, 2);
    EXPECT_EQ(material.occlusion.texture, 1);
    EXPECT_EQ(material.occlusion.uvSet, 1);
    EXPECT_EQ(material.emissive.texture, 0);
    EXPECT_EQ(scene.images.size(), 1u) << "one image, however many textures show it";
}

TEST(GltfMaterials, ClampFactorsWithAWarning)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.primitive()["material"] = 0;
    builder.json["materials"] = {
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {2, -1, 0.5, 1}}, {"metallicFactor", 1.5}, {"roughnessFactor", -0.5}}},
         {"emissiveFactor", {3, 0, 0}},
         {"alphaCutoff", -1}}};
    const LoadedScene loaded = load(builder);
    const Material& material = loaded.scene.materials.at(0);
    EXPECT_EQ(material.baseColorFactor, dvec4(1, 0, 0.5, 1));
    EXPECT_EQ(material.metallicFactor, 1.0);
    EXPECT_EQ(material.roughnessFactor, 0.0);
    EXPECT_EQ(material.emissiveFactor, dvec3(1, 0, 0));
    EXPECT_EQ(material.alphaCutoff, 0.0);
    EXPECT_EQ(warningsAbout(loaded, "/materials/0/baseColorFactor: is outside 0 to 1"), 1)
        << "once, for two components";
    EXPECT_EQ(loaded.warnings.size(), 5u);
}

TEST(GltfMaterials, ReadTheIndexOfRefraction)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.primitive()["material"] = 0;
    const auto load1 = [&](const nlohmann::json& extension) {
        builder.json["materials"] = {{{"extensions", {{"KHR_materials_ior", extension}}}}};
        return load(builder);
    };
    EXPECT_EQ(load1(nlohmann::json::object()).scene.materials.at(0).ior, 1.5);
    EXPECT_EQ(load1({{"ior", 1.31}}).scene.materials.at(0).ior, 1.31);
    EXPECT_EQ(load1({{"ior", 0}}).scene.materials.at(0).ior, 0.0) << "KHR_materials_ior: F0 is 1";
    EXPECT_EQ(warningsAbout(load1({{"ior", 0}}), "ior"), 0);
    for (const auto& [refused, used] : {std::pair(0.5, 1.0), std::pair(-1.0, 1.0), std::pair(1e300, 1e6)}) {
        const LoadedScene loaded = load1({{"ior", refused}});
        EXPECT_EQ(loaded.scene.materials.at(0).ior, used);
        EXPECT_EQ(warningsAbout(loaded, "/materials/0/ior: is neither 0 nor in 1 to 1000000"), 1);
    }
}

TEST(GltfMaterials, RefuseWhatTheyCannotMean)
{
    GltfBuilder builder = textured();
    builder.json["materials"][0]["alphaMode"] = "GLASS";
    EXPECT_TRUE(contains(errorOf(builder), "/materials/0: has the unknown alphaMode \"GLASS\""));
    builder = textured();
    builder.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1};
    EXPECT_TRUE(contains(errorOf(builder), "baseColorFactor: has 3 elements where 4 are due"));
    builder = textured();
    baseColorTexture(builder)["index"] = 1;
    EXPECT_TRUE(contains(errorOf(builder), "/baseColorTexture/index: refers to textures/1 of 1"));
}

// KHR_texture_transform: scale, then a rotation counter-clockwise about the origin as seen with v pointing down, then
// the offset. A quarter turn takes (1, 0), to the right, to (0, -1), up.
TEST(GltfMaterials, TransformTextureCoordinates)
{
    GltfBuilder builder = textured();
    baseColorTexture(builder)["extensions"]["KHR_texture_transform"] = {
        {"offset", {0.5, 0.25}}, {"rotation", kPi / 2.0}, {"scale", {2, 3}}};
    const TextureUse use = load(builder).scene.materials.at(0).baseColor;
    const auto at = [&](double u, double v) { return use.transform * dvec3(u, v, 1.0); };
    EXPECT_LE(glm::length(at(0, 0) - dvec2(0.5, 0.25)), 1e-15);
    EXPECT_LE(glm::length(at(1, 0) - dvec2(0.5, 0.25 - 2.0)), 1e-15);
    EXPECT_LE(glm::length(at(0, 1) - dvec2(0.5 + 3.0, 0.25)), 1e-15);
}

TEST(GltfMaterials, LetTheTransformChooseTheCoordinates)
{
    GltfBuilder builder = textured();
    builder.primitive()["attributes"]["TEXCOORD_1"] = builder.addFloats({.5f, .5f, .5f, .5f, .5f, .5f}, "VEC2");
    baseColorTexture(builder)["extensions"]["KHR_texture_transform"] = {{"texCoord", 1}};
    EXPECT_EQ(load(builder).scene.materials.at(0).baseColor.uvSet, 1);
}

TEST(GltfMaterials, TakeAnyTwoSetsOfCoordinates)
{
    GltfBuilder builder = textured();
    builder.primitive()["attributes"]["TEXCOORD_3"] = builder.addFloats({7, 7, 7, 7, 7, 7}, "VEC2");
    builder.json["materials"][0]["emissiveTexture"] = {{"index", 0}, {"texCoord", 3}};
    const Scene scene = load(builder).scene;
    EXPECT_EQ(scene.materials.at(0).baseColor.uvSet, 0);
    EXPECT_EQ(scene.materials.at(0).emissive.uvSet, 1);
    EXPECT_EQ(scene.primitives.at(0).uvs[1].at(0), vec2(7, 7));

    builder.json["materials"][0]["normalTexture"] = {{"index", 0}, {"texCoord", 1}};
    EXPECT_TRUE(contains(errorOf(builder), "/materials/0: samples 3 sets"));
}

TEST(GltfMaterials, FillMissingCoordinatesWithAWarning)
{
    GltfBuilder builder = textured();
    builder.primitive()["attributes"].erase("TEXCOORD_0");
    const LoadedScene loaded = load(builder);
    EXPECT_EQ(loaded.scene.primitives.at(0).uvs[0], std::vector<vec2>(3, vec2(0.0f)));
    EXPECT_EQ(warningsAbout(loaded, "is textured by TEXCOORD_0, which it does not have"), 1);
}

TEST(GltfTextures, DecodeImagesInsideTheFile)
{
    const Scene scene = load(textured()).scene;
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].width, 2);
    EXPECT_EQ(scene.images[0].height, 1);
    EXPECT_EQ(scene.images[0].texels.at(4 + 1), std::byte{255});
    EXPECT_EQ(scene.images[0].texels.at(4 + 3), std::byte{128});
    EXPECT_EQ(scene.textures.at(0).image, 0);
    EXPECT_EQ(scene.textures.at(0).sampler, Sampler{});
}

TEST(GltfTextures, DecodeOnlyWhatIsDrawn)
{
    GltfBuilder builder = textured();
    builder.json["images"].push_back({{"uri", "never-opened.png"}});
    builder.json["textures"] = {{{"source", 1}}, {{"source", 0}}};
    const nlohmann::json drawn = {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}}}};
    builder.json["materials"] = {{{"emissiveTexture", {{"index", 0}}}}, drawn};
    builder.primitive()["material"] = 1;
    const LoadedScene loaded = load(builder);
    EXPECT_EQ(loaded.scene.materials.size(), 1u);
    EXPECT_EQ(loaded.scene.primitives.at(0).material, 0);
    EXPECT_EQ(loaded.scene.materials.at(0).baseColor.texture, 0);
    EXPECT_EQ(loaded.facts.materials.count(), 2u) << "facts are about the file";
}

TEST(GltfTextures, ReadEverySampler)
{
    struct Row
    {
        int minFilter;
        Filter minify;
        MipFilter mip;
    };
    for (const Row& row :
         {Row{9728, Filter::nearest, MipFilter::none}, Row{9729, Filter::linear, MipFilter::none},
          Row{9984, Filter::nearest, MipFilter::nearest}, Row{9985, Filter::linear, MipFilter::nearest},
          Row{9986, Filter::nearest, MipFilter::linear}, Row{9987, Filter::linear, MipFilter::linear}})
    {
        GltfBuilder builder = textured();
        builder.json["samplers"] = {
            {{"minFilter", row.minFilter}, {"magFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33648}}};
        builder.json["textures"][0]["sampler"] = 0;
        const Sampler sampler = load(builder).scene.textures.at(0).sampler;
        EXPECT_EQ(sampler.minify, row.minify) << row.minFilter;
        EXPECT_EQ(sampler.mip, row.mip) << row.minFilter;
        EXPECT_EQ(sampler.magnify, Filter::nearest);
        EXPECT_EQ(sampler.wrapS, Wrap::clampToEdge);
        EXPECT_EQ(sampler.wrapT, Wrap::mirroredRepeat);
    }
    for (const char* property : {"minFilter", "magFilter", "wrapS", "wrapT"}) {
        GltfBuilder builder = textured();
        builder.json["samplers"] = {{{property, 12345}}};
        builder.json["textures"][0]["sampler"] = 0;
        EXPECT_TRUE(contains(errorOf(builder), "/samplers/0: has the unknown")) << property;
    }
}

TEST(GltfTextures, PreferTheWebpOfATexture)
{
    GltfBuilder builder = textured();
    // The PNG stands in for a WebP: what matters is which image is taken, and the format is told by its bytes.
    builder.json["images"].push_back({{"uri", "fallback-that-is-not-opened.png"}});
    builder.json["textures"][0] = {{"source", 1}, {"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
    builder.json["extensionsUsed"] = {"EXT_texture_webp"};
    EXPECT_EQ(load(builder).scene.images.size(), 1u);
}

TEST(GltfTextures, RefuseImagesThatAreNotThere)
{
    GltfBuilder builder = textured();
    builder.json["textures"][0].erase("source");
    EXPECT_TRUE(contains(errorOf(builder), "/textures/0: has no image in a format that is supported"));
    builder = textured();
    builder.json["images"][0] = {{"uri", "missing.png"}};
    EXPECT_TRUE(contains(errorOf(builder), "/images/0")) << errorOf(builder);
    EXPECT_TRUE(contains(errorOf(builder), "missing.png): no such file"));
    builder.json["images"][0] = {{"name", "nothing"}};
    EXPECT_TRUE(contains(errorOf(builder), "/images/0: has neither a bufferView nor a URI"));
    builder.json["images"][0] = {{"uri", "."}};
    EXPECT_TRUE(contains(errorOf(builder), "is a folder"));
}

TEST(GltfTextures, RefuseDamagedImagesByTheFirstOfThem)
{
    GltfBuilder builder = textured();
    const int whole = builder.json["images"][0]["bufferView"];
    builder.view(whole)["byteLength"] = 30;
    builder.json["images"].push_back({{"bufferView", builder.addView(std::vector<std::uint8_t>{1, 2, 3, 4})}});
    builder.json["textures"].push_back({{"source", 1}});
    builder.json["materials"][0]["emissiveTexture"] = {{"index", 1}};
    for (int run = 0; run < 20; ++run)
        EXPECT_TRUE(contains(errorOf(builder), "/images/0")) << "whichever thread fails first: " << errorOf(builder);
}

TEST(GltfTextures, RefuseImagesOfNoSizeOrTooLarge)
{
    for (const auto& [width, height] : {std::pair(0u, 1u), std::pair(1u, 0u), std::pair(60000u, 60000u)}) {
        test::PngSpec spec;
        spec.width = width;
        spec.height = height;
        const std::string png = test::pngBytes(spec);
        GltfBuilder builder = textured();
        builder.json["images"][0]["bufferView"] = builder.addView(std::vector<char>(png.begin(), png.end()));
        EXPECT_TRUE(contains(errorOf(builder), "/images/0")) << width << " x " << height << ": " << errorOf(builder);
    }
}

TEST(GltfExtensions, RefuseWhatIsRequiredAndUnknown)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["extensionsUsed"] =
        builder.json["extensionsRequired"] = {"KHR_texture_transform", "KHR_moon_dust", "EXT_x"};
    EXPECT_TRUE(contains(errorOf(builder), "cannot be drawn without KHR_moon_dust, EXT_x"));
    const TestFolder folder;
    const SceneFacts facts = readFacts(folder.write("model.glb", builder.glb()));
    ASSERT_EQ(facts.extensions.size(), 3u);
    EXPECT_EQ(facts.extensions[1].name, "KHR_moon_dust");
    EXPECT_TRUE(facts.extensions[1].required);
    EXPECT_FALSE(facts.extensions[1].supported);
    EXPECT_TRUE(facts.extensions[2].supported);
}

TEST(GltfExtensions, WarnOnceOfWhatIsMerelyUsed)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["extensionsUsed"] = {"KHR_moon_dust", "KHR_lights_punctual"};
    const LoadedScene loaded = load(builder);
    EXPECT_EQ(loaded.warnings.size(), 1u);
    EXPECT_EQ(warningsAbout(loaded, "uses KHR_moon_dust"), 1);
}

TEST(GltfExtensions, WarnOnceOfAnimations)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["animations"] = {{{"name", "walk"}}, {{"name", "run"}}};
    const LoadedScene loaded = load(builder);
    EXPECT_EQ(loaded.warnings.size(), 1u);
    EXPECT_EQ(warningsAbout(loaded, "animations"), 1);
    EXPECT_EQ(loaded.facts.animations.names, (std::vector<std::string>{"walk", "run"}));
}

} // namespace
} // namespace torrance
