// What is packed into fewer textures is read from where it was put, and what cannot be packed is not.
#include "plan/texture_plan.h"

#include "plan/shading_plan.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

using test::addTexture;
using test::sceneWith;
using test::settings;

/// A material whose every texture varies in every channel; images 0 to 4 in the order of TextureRole.
Scene fullScene()
{
    Scene scene = sceneWith({.emissiveFactor = dvec3(1.0)});
    Material& m = scene.materials[0];
    m.baseColor = addTexture(scene, {1, 2, 3, 4}, {5, 6, 7, 8});
    m.metallicRoughness = addTexture(scene, {0, 20, 30, 0}, {0, 60, 70, 0});
    m.normal = addTexture(scene, {10, 20, 255, 0}, {127, 128, 200, 0});
    m.occlusion = addTexture(scene, {9, 0, 0, 0}, {99, 0, 0, 0});
    m.emissive = addTexture(scene, {1, 2, 3, 4}, {5, 6, 7, 8});
    return scene;
}

struct Planned
{
    ShadingPlan plan;
    const Batch& batch() const { return plan.batches.empty() ? plan.blended[0] : plan.batches[0]; }
    const ShaderKey& key() const { return batch().key; }
    const PlannedTexture& texture(TextureRole role) const
    {
        return plan.textures[static_cast<std::size_t>(batch().textures[static_cast<std::size_t>(role)])];
    }
    bool has(TextureRole role) const { return batch().textures[static_cast<std::size_t>(role)] >= 0; }
};

Settings withFilter(const char* filter)
{
    Settings own = settings("standard");
    own.methods.textureFilter = brdf::findMethod(brdf::Slot::textureFilter, filter);
    return own;
}

Planned planned(const Scene& scene, const char* filter = "trilinear")
{
    return {makePlan(scene, withFilter(filter))};
}

TEST(TexturePlan, PutsScalarsIntoAlphasThatNothingReads)
{
    const Planned p = planned(fullScene());
    EXPECT_EQ(p.plan.textures.size(), 3u);
    EXPECT_EQ(p.key().metallic, ScalarPlace::baseColorAlpha);
    EXPECT_EQ(p.key().roughness, ScalarPlace::normalAlpha);
    EXPECT_EQ(p.key().ambient, ScalarPlace::emissiveAlpha);
    EXPECT_EQ(p.texture(TextureRole::baseColor).channels[3], (ChannelSource{1, 2}));
    EXPECT_EQ(p.texture(TextureRole::normal).channels[3], (ChannelSource{1, 1}));
    EXPECT_EQ(p.texture(TextureRole::emissive).channels[3], (ChannelSource{3, 0}));
    EXPECT_EQ(p.texture(TextureRole::baseColor).channels[1], (ChannelSource{0, 1}));
    EXPECT_FALSE(p.has(TextureRole::material));
    EXPECT_FALSE(p.has(TextureRole::occlusion));
}

TEST(TexturePlan, LeavesAnAlphaThatIsRead)
{
    Scene scene = fullScene();
    scene.materials[0].alphaMode = AlphaMode::blend;
    const Planned p = planned(scene);
    EXPECT_EQ(p.texture(TextureRole::baseColor).channels[3], (ChannelSource{0, 3}));
    EXPECT_NE(p.key().metallic, ScalarPlace::baseColorAlpha);
    Settings toksvig = withFilter("trilinear");
    toksvig.methods.specularAntialiasing = brdf::findMethod(brdf::Slot::specularAntialiasing, "toksvig");
    EXPECT_NE(makePlan(fullScene(), toksvig).batches[0].key.roughness, ScalarPlace::normalAlpha);
}

TEST(TexturePlan, SharesOneTextureWhereAlphasAreTooFew)
{
    Scene scene = fullScene();
    scene.materials[0].emissive = {};
    scene.materials[0].normal = {};
    const Planned p = planned(scene);
    EXPECT_EQ(p.plan.textures.size(), 2u);
    const PlannedTexture& scalars = p.texture(TextureRole::material);
    EXPECT_EQ(scalars.channels, (std::array<ChannelSource, 4>{{{3, 0}, {1, 1}, {1, 2}, {}}}));
    for (const ScalarPlace place : {p.key().roughness, p.key().metallic, p.key().ambient})
        EXPECT_EQ(place, ScalarPlace::material);
}

TEST(TexturePlan, PacksOnlyWhatIsSampledAlike)
{
    Scene other = fullScene();
    other.textures[1].sampler.wrapS = Wrap::clampToEdge; // of metallic and roughness
    EXPECT_EQ(planned(other).key().roughness, ScalarPlace::material);
    Scene turned = fullScene();
    turned.materials[0].metallicRoughness.transform[0][0] = 2.0;
    EXPECT_EQ(planned(turned).key().metallic, ScalarPlace::material);
    Scene larger = fullScene();
    larger.images[3].width = 1; // occlusion
    larger.images[3].height = 2;
    EXPECT_EQ(planned(larger).key().ambient, ScalarPlace::own);
    Scene deeper = fullScene();
    TextureImage& image = deeper.images[1];
    image.format = TexelFormat::rgba16; // more bits than the alphas of 8
    std::vector<std::byte> wide;
    for (const std::byte code : image.texels)
        wide.insert(wide.end(), 2, code);
    image.texels = wide;
    EXPECT_EQ(planned(deeper).key().roughness, ScalarPlace::material);
}

TEST(TexturePlan, UploadsATextureOnceThatTwoMaterialsRead)
{
    Scene scene = fullScene();
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].roughnessFactor = 0.5;
    scene.primitives.push_back(test::triangle(1));
    scene.instances.push_back({.primitive = 1});
    const ShadingPlan plan = makePlan(scene, withFilter("trilinear"));
    EXPECT_EQ(plan.textures.size(), 3u);
    ASSERT_EQ(plan.batches.size(), 1u);
    EXPECT_EQ(plan.batches[0].draws.size(), 2u);
    EXPECT_NE(plan.batches[0].draws[0].block, plan.batches[0].draws[1].block);
}

TEST(TexturePlan, PutsAllTexelsIntoWords)
{
    const Planned p = planned(fullScene(), "trilinear_words");
    EXPECT_EQ(planned(fullScene(), "nearest_level").plan.textures, p.plan.textures);
    ASSERT_EQ(p.plan.textures.size(), 1u);
    ASSERT_TRUE(p.has(TextureRole::words));
    EXPECT_EQ(p.texture(TextureRole::words).words,
              (WordChannels{
                  {{0, 0}, {0, 1}, {0, 2}, {1, 2}, {2, 0}, {2, 1}, {2, 2}, {1, 1}, {4, 0}, {4, 1}, {4, 2}, {3, 0}}}));
    EXPECT_EQ(p.texture(TextureRole::words).width, 2);
    EXPECT_TRUE(p.key().words.used && p.key().baseColor.used && p.key().normal.used && p.key().emissive.used);
    EXPECT_FALSE(p.key().material.used || p.key().occlusion.used);
    for (const ScalarPlace place : {p.key().roughness, p.key().metallic, p.key().ambient})
        EXPECT_EQ(place, ScalarPlace::words);
}

TEST(TexturePlan, WordsHoldOnlyWhatIsRead)
{
    Scene scene = fullScene();
    scene.materials[0].occlusion = {};
    scene.materials[0].metallicRoughness = addTexture(scene, {0, 51, 30, 0}, {0, 51, 70, 0}); // image 5
    const Planned p = planned(scene, "trilinear_words");
    ASSERT_TRUE(p.has(TextureRole::words));
    const WordChannels& channels = *p.texture(TextureRole::words).words;
    EXPECT_EQ(channels[3], (ChannelSource{5, 2}));
    EXPECT_EQ(channels[7], ChannelSource{}) << "the roughness is a factor";
    EXPECT_EQ(channels[11], ChannelSource{});
    EXPECT_EQ(p.key().roughness, ScalarPlace::constant);
    EXPECT_EQ(p.key().ambient, ScalarPlace::constant);
}

TEST(TexturePlan, WordsHoldWhatTheyCan)
{
    const auto refuses = [](const char* why, const auto& change) {
        Scene scene = fullScene();
        change(scene);
        const Planned p = planned(scene, "trilinear_words");
        EXPECT_FALSE(p.has(TextureRole::words)) << why;
        const Planned plain = planned(scene);
        EXPECT_EQ(p.key(), plain.key()) << why;
        EXPECT_EQ(p.plan.textures, plain.plan.textures) << why;
    };
    refuses("two textures", [](Scene& s) { s.materials[0].emissive = s.materials[0].normal = {}; });
    refuses("an alpha that is read", [](Scene& s) { s.materials[0].alphaMode = AlphaMode::mask; });
    refuses("another place", [](Scene& s) { s.materials[0].normal.transform[0][0] = 2.0; });
    refuses("another sampler", [](Scene& s) { s.textures[2].sampler.minify = Filter::nearest; });
    refuses("what is not repeated", [](Scene& s) {
        for (Texture& texture : s.textures)
            texture.sampler.wrapT = Wrap::mirroredRepeat;
    });
    refuses("no levels", [](Scene& s) {
        for (Texture& texture : s.textures)
            texture.sampler.mip = MipFilter::none;
    });
    refuses("another size", [](Scene& s) { std::swap(s.images[4].width, s.images[4].height); });
    refuses("more bits", [](Scene& s) {
        s.images[0].format = TexelFormat::rgba16;
        std::vector<std::byte> wide;
        for (const std::byte code : s.images[0].texels)
            wide.insert(wide.end(), 2, code);
        s.images[0].texels = wide;
    });
    refuses("a place that the primitive has not", [](Scene& s) { s.materials[0].baseColor.uvSet = 1; });
    Scene large = fullScene();
    const std::vector<TexelFacts> facts = texelFacts(large);
    for (const auto& [width, height, fits] : {std::tuple(8192, 8192, true), {8192, 8193, false}}) {
        for (TextureImage& image : large.images) {
            image.width = width;
            image.height = height;
        }
        EXPECT_EQ(makePlan(large, facts, withFilter("trilinear_words")).batches[0].key.words.used, fits) << height;
    }
    Settings toksvig = withFilter("trilinear_words");
    toksvig.methods.specularAntialiasing = brdf::findMethod(brdf::Slot::specularAntialiasing, "toksvig");
    EXPECT_FALSE(makePlan(fullScene(), toksvig).batches[0].key.words.used) << "lengths of normals";
}

TEST(TexturePlan, FoldsAConstantChannelBesideOneThatVaries)
{
    Scene scene = fullScene();
    scene.materials[0].metallicRoughness = addTexture(scene, {0, 51, 30, 0}, {0, 51, 70, 0});
    const Planned p = planned(scene);
    EXPECT_EQ(p.key().roughness, ScalarPlace::constant);
    EXPECT_DOUBLE_EQ(p.plan.materials[0].material.roughnessFactor, 51.0 / 255.0);
    EXPECT_NE(p.key().metallic, ScalarPlace::constant);
}

} // namespace
} // namespace torrance
