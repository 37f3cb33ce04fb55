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

Planned planned(const Scene& scene)
{
    return {makePlan(scene, settings("standard"))};
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
    Settings toksvig = settings("standard");
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
    const ShadingPlan plan = makePlan(scene, settings("standard"));
    EXPECT_EQ(plan.textures.size(), 3u);
    ASSERT_EQ(plan.batches.size(), 1u);
    EXPECT_EQ(plan.batches[0].draws.size(), 2u);
    EXPECT_NE(plan.batches[0].draws[0].block, plan.batches[0].draws[1].block);
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
