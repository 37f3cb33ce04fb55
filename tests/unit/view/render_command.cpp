#include "view/render_command.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

struct Opened
{
    ViewerHost host;
    ViewerState state;

    Opened()
    {
        state.scene = std::make_unique<SceneOnDevice>();
        state.scene->input = "models/it's a cup.glb";
        state.scene->scene().materials.resize(1);
        state.history.emplace(editsOf(state.scene->scene(), {}));
        state.settings.methods = *brdf::findPreset("standard");
        host.settings = state.settings;
        host.lampOf = [](const brdf::Preset& preset) {
            return preset.light.empty() ? std::nullopt : std::optional(Light{.name = std::string(preset.id)});
        };
        state.settings.width = 640;
        state.settings.height = 360;
        state.write = {.tone = findToneCurve("khronos_neutral"), .transfer = findTransferCurve("srgb")};
    }
};

TEST(RenderCommand, OfAFreshSceneSaysNoMoreThanItMust)
{
    const Opened opened;
    EXPECT_EQ(renderCommandOf(opened.state, opened.host).text,
              "torrance render 'models/it'\\''s a cup.glb' --orbit=30,75 --environment=studio --resolution=640x360 -o "
              "'it'\\''s a cup.png'");
    EXPECT_TRUE(renderCommandOf(opened.state, opened.host).lost.empty());
}

TEST(RenderCommand, SaysEverythingThatWasChanged)
{
    Opened opened;
    ViewerState& state = opened.state;
    opened.host.sceneOptions = {"--light=directional:direction=0,1,1"};
    state.view = FileView{2};
    state.settings.methods = *brdf::findPreset("gltf");
    state.settings.methods.distribution = brdf::findMethod(brdf::Slot::distribution, "beckmann");
    LightMethods own = lightMethodsOf(state.settings);
    own.methods[1] = brdf::findMethod(kLightSlots[1], "vndf_bounded");
    own.environmentSamples = 16;
    state.settings.ofMaterials = {{3, own}};
    state.settings.path = RenderPath::prepass;
    state.settings.triangleCulling = false;
    state.settings.background = BackgroundKind::transparent;
    state.fileSamples = 4;
    state.write.exposure = -0.5;
    state.write.tone = findToneCurve("agx");
    Edits edits = state.edits();
    edits.environment = {.name = "a b.hdr", .rotation = 12.5, .intensity = 2.0};
    state.history->commit(edits);
    const std::vector<std::string> expected = {"models/it's a cup.glb",
                                               "--light=directional:direction=0,1,1",
                                               "--camera-index=2",
                                               "--environment=a b.hdr",
                                               "--environment-rotation=12.5",
                                               "--environment-intensity=2",
                                               "--preset=gltf",
                                               "--distribution=beckmann",
                                               "--material-methods=" + materialMethodsText(3, own),
                                               "--path=prepass",
                                               "--triangle-culling=off",
                                               "--resolution=640x360",
                                               "--samples=4",
                                               "--no-background",
                                               "--exposure=-0.5",
                                               "--tone=agx"};
    EXPECT_EQ(renderArguments(state, opened.host), expected);
}

TEST(RenderCommand, NamesWhatNoOptionSays)
{
    Opened opened;
    Edits edits = opened.state.edits();
    edits.materials[0].roughnessFactor = 0.25;
    edits.lights.resize(1);
    opened.state.history->commit(edits);
    EXPECT_EQ(renderCommandOf(opened.state, opened.host).lost, (std::vector<std::string>{"materials", "lights"}));
}

TEST(RenderCommand, APresetsOwnLampComesWithThePreset)
{
    Opened opened;
    opened.state.settings.methods = *brdf::findPreset("ue4-direct");
    Edits edits = opened.state.edits();
    edits.lights.push_back(*opened.host.lampOf(opened.state.settings.methods));
    opened.state.history->commit(edits);
    EXPECT_TRUE(renderCommandOf(opened.state, opened.host).lost.empty());
}

} // namespace
} // namespace torrance
