// What a picture costs, counted and not timed: pipelines, draws, texels fetched, pixels shaded, bytes on the device.
#include "drawing.h"
#include "gpu/test_device.h"
#include "passes/surface_pass.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "study/bench_item.h"
#include "study/growth_scenes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr int kSize = 64; // pixels a side

/// How many fragments pass the depth and stencil tests in every command buffer that is recorded meanwhile, in order:
/// where a shader discards nothing, those that are shaded. lavapipe's own count of invocations is of blocks of 4 x 4
/// pixels before the test.
class FragmentCounter
{
public:
    FragmentCounter()
        : pool(device().handle, vk::QueryPoolCreateInfo{.queryType = vk::QueryType::eOcclusion, .queryCount = kMost})
    {
        device().hooks = {
            .begun =
                [&](const vk::raii::CommandBuffer& commands) {
                    commands.resetQueryPool(*pool, count, 1);
                    commands.beginQuery(*pool, count, vk::QueryControlFlagBits::ePrecise);
                },
            .ending = [&](const vk::raii::CommandBuffer& commands) { commands.endQuery(*pool, count++); }};
    }
    ~FragmentCounter() { device().hooks = {}; }
    FragmentCounter(const FragmentCounter&) = delete;
    FragmentCounter& operator=(const FragmentCounter&) = delete;

    std::vector<std::uint64_t> passed() const
    {
        std::vector<std::uint64_t> result(count);
        if (count > 0)
            result = pool.getResults<std::uint64_t>(0, count, count * sizeof(std::uint64_t), sizeof(std::uint64_t),
                                                    vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait)
                         .second;
        return result;
    }

private:
    static constexpr std::uint32_t kMost = 64;
    vk::raii::QueryPool pool;
    std::uint32_t count = 0;
};

bool countsFragments()
{
    return device().physical.getFeatures().occlusionQueryPrecise;
}

constexpr int kLayers = 4;

/// Squares that each fill the picture, one behind the other, the farthest drawn first.
Scene stackedSquares()
{
    Scene scene;
    scene.materials.emplace_back().name = "grey";
    for (int i = 0; i < kLayers; ++i)
        addInstance(scene, square(0), translation(dvec3(0.0, 0.0, 0.1 * i)));
    scene.lights.push_back({.name = "sun", .direction = dvec3(0.0, 0.0, -1.0)});
    return scene;
}

Camera straightOn()
{
    Camera camera;
    camera.kind = Camera::Kind::orthographic;
    camera.worldFromCamera[3] = dvec4(0.0, 0.0, 2.0, 1.0);
    camera.farPlane = 10.0;
    return camera;
}

/// The fragments that are shaded in each pass of one frame.
std::vector<std::uint64_t> fragmentsByPass(const Scene& scene, const Camera& camera, RenderPath path)
{
    Settings settings = settingsOf("gltf", kSize);
    settings.path = path;
    const ShadingPlan plan = makePlan(scene, settings);
    Renderer renderer(device(), shaders(), {});
    const DeviceScene onDevice = renderer.upload(scene, plan);
    const FragmentCounter counter;
    renderer.drawFrame(onDevice, camera, [](const char*, const std::function<void()>& draw) { draw(); });
    return counter.passed();
}

constexpr std::uint64_t kPixels = std::uint64_t(kSize) * kSize;

TEST(CountedWork, ForwardShadesWhatIsHiddenLater)
{
    if (!countsFragments())
        GTEST_SKIP() << "the device does not count";
    const auto fragments = fragmentsByPass(stackedSquares(), straightOn(), RenderPath::forward);
    ASSERT_EQ(fragments.size(), 1u);
    EXPECT_EQ(fragments[0], kLayers * kPixels) << "farthest first: what a depth pass saves";
}

TEST(CountedWork, AfterADepthPassEachPixelIsShadedOnce)
{
    if (!countsFragments())
        GTEST_SKIP() << "the device does not count";
    const auto fragments = fragmentsByPass(stackedSquares(), straightOn(), RenderPath::prepass);
    ASSERT_EQ(fragments.size(), 2u);
    EXPECT_EQ(fragments[0], kLayers * kPixels) << "depth alone";
    EXPECT_EQ(fragments[1], kPixels);
}

TEST(CountedWork, FromAttributesEachPixelIsShadedOnce)
{
    if (!countsFragments())
        GTEST_SKIP() << "the device does not count";
    const auto fragments = fragmentsByPass(stackedSquares(), straightOn(), RenderPath::attributes);
    ASSERT_EQ(fragments.size(), 2u);
    EXPECT_EQ(fragments[0], kLayers * kPixels) << "attributes are written where the depth test passes";
    EXPECT_EQ(fragments[1], kPixels);
}

/// How often an instruction stands in a SPIR-V module (SPIR-V 1.6, 2.3: words from 5 on, count << 16 | opcode).
int countInstructions(const gpu::CompiledShader& shader, std::uint32_t opcode)
{
    int count = 0;
    for (std::size_t at = 5; at < shader.words.size(); at += shader.words[at] >> 16)
        count += (shader.words[at] & 0xffffu) == opcode ? 1 : 0;
    return count;
}

TEST(CountedWork, FiveTexturesOfAMaterialAreThreeFetches)
{
    constexpr std::uint32_t kSampleImplicitLod = 87; // OpImageSampleImplicitLod: what texture() becomes
    const Scene scene = texturedTorus();             // five textures of one size, sampled alike
    const ShadingPlan plan = makePlan(scene, settingsOf("standard", kSize));
    const gpu::CompiledShader shader = shaders().get("passes/surface.frag", selectedText(plan, plan.batches[0].key));
    EXPECT_EQ(countInstructions(shader, kSampleImplicitLod), 3);
}

/// How many inputs of a fragment shader, or outputs of a vertex shader, are the same at all vertices (SPIR-V 1.6,
/// 3.32.17 and 3.20: OpDecorate target Flat).
int countFlat(const gpu::CompiledShader& shader)
{
    constexpr std::uint32_t kDecorate = 71, kFlat = 14;
    int count = 0;
    for (std::size_t at = 5; at < shader.words.size(); at += shader.words[at] >> 16)
        count += (shader.words[at] & 0xffffu) == kDecorate && shader.words[at + 2] == kFlat ? 1 : 0;
    return count;
}

// A fragment's uniform blocks are read lane by lane on a processor (shaders/passes/flat_uniforms.glsl).
TEST(CountedWork, VertexShadersTellFragmentsTheirUniforms)
{
    Scene scene = stackedSquares();
    scene.environment = uniformEnvironment(dvec3(0.5));
    Settings settings = settingsOf("standard", kSize);
    settings.path = RenderPath::attributes;
    const ShadingPlan plan = makePlan(scene, settings);
    const Batch& batch = plan.batches[0];
    const std::string told = flatUniformsText(device());
    EXPECT_EQ(told.empty(), !device().description.isProcessor());
    const std::string always = "#define FLAT_UNIFORMS\n";
    // The eye, three of the environment, two of the light, three of the material.
    EXPECT_EQ(countFlat(shaders().get("passes/surface.frag", selectedText(plan, batch.key) + always)), 9);
    EXPECT_EQ(countFlat(shaders().get("passes/surface.vert", selectedText(plan, batch.key) + always)), 9);
    // Three of the pixels' rays and two of texture levels.
    ASSERT_EQ(plan.classes.size(), 1u);
    const std::string resolve = resolveText(plan, plan.classes[0]) + always;
    EXPECT_EQ(countFlat(shaders().get("passes/resolve.vert", resolve)), 14);
    EXPECT_EQ(countFlat(shaders().get("passes/surface.vert", attributesText(plan, batch))), 0)
        << "attributes of small triangles cost by what each vertex holds";
}

TEST(CountedWork, AnOpaqueMeshIsTwoPipelines)
{
    for (const RenderPath path : {RenderPath::prepass, RenderPath::attributes}) {
        Settings settings = settingsOf("gltf", kSize);
        settings.path = path;
        const Scene scene = stackedSquares();
        const ShadingPlan plan = makePlan(scene, settings);
        Renderer renderer(device(), shaders(), {});
        const DeviceScene onDevice = renderer.upload(scene, plan);
        renderer.render(onDevice, straightOn());
        EXPECT_EQ(renderer.pipelineCount(), 2u);
    }
}

TEST(CountedWork, SurfacesOfOneSideAndOfTwoShareAShader)
{
    Scene scene = stackedSquares();
    const ShadingPlan one = makePlan(scene, settingsOf("gltf", kSize));
    scene.materials[0].doubleSided = true;
    const ShadingPlan two = makePlan(scene, settingsOf("gltf", kSize));
    EXPECT_EQ(selectedText(one, one.batches[0].key), selectedText(two, two.batches[0].key));
}

TEST(CountedWork, TenThousandInstancesAreOneDraw)
{
    const auto series = growthSeries();
    const auto found = std::ranges::find(series, "instances", &GrowthSeries::id);
    ASSERT_NE(found, series.end());
    const Scene scene = found->makeScene(10000);
    ASSERT_EQ(scene.instances.size(), 10000u);
    EXPECT_EQ(drawCount(makePlan(scene, settingsOf("gltf", kSize))), 1u);
}

TEST(CountedWork, TheDeviceHoldsWhatTheSceneHas)
{
    Scene scene;
    scene.materials.push_back({});
    const auto color = [](int x, int y) { return dvec4(x / 8.0, y / 8.0, 0.5, 1.0); };
    scene.materials[0].baseColor.texture = addTexture(scene, makeTexels(8, 8, TexelFormat::rgba8, color), {});
    addInstance(scene, square(0), dmat4(1.0));
    const ShadingPlan plan = makePlan(scene, settingsOf("gltf", kSize));
    Renderer renderer(device(), shaders(), {});
    const DeviceScene onDevice = renderer.upload(scene, plan);
    // Four vertices of position, normal, tangent and uv in floats; six indices.
    EXPECT_EQ(onDevice.meshes->vertices.size, 4u * (3 + 3 + 4 + 2) * sizeof(float));
    EXPECT_EQ(onDevice.meshes->indices.size, 6u * sizeof(std::uint32_t));
    ASSERT_EQ(plan.textures.size(), 1u);
    const gpu::ImageShape& shape = onDevice.textures->image(0).shape;
    EXPECT_EQ(shape.width * shape.height, 64u);
    EXPECT_EQ(shape.mips, 4u);
    EXPECT_EQ(shape.format, vk::Format::eR16G16B16A16Sfloat) << "a colour of 8 bits";
}

// Whoever owns the scene may free an image's texels as soon as the last texture that is made of them is there.
TEST(CountedWork, TexelsCanBeFreedOneImageAfterTheOther)
{
    Scene scene = demoScene();
    scene.images.push_back({.name = "unread", .width = 1, .height = 1, .texels = std::vector<std::byte>(4)});
    Settings settings = settingsOf("standard", kSize);
    const Camera camera = fitCamera(scene, {0.5, 1.2}, 1.0, 0.7, 0.05);
    const Picture whole = draw(scene, camera, settings);
    const ShadingPlan plan = makePlan(scene, settings);
    ASSERT_GT(plan.textures.size(), 1u);
    Renderer renderer(device(), shaders(), {});
    std::vector<int> freed;
    const DeviceScene onDevice = renderer.upload(scene, plan, nullptr, [&](int image) {
        std::vector<std::byte>& texels = scene.images[static_cast<std::size_t>(image)].texels;
        std::fill(texels.begin(), texels.end(), std::byte{0x55}); // whoever reads it again draws another picture
        freed.push_back(image);
    });
    std::ranges::sort(freed);
    for (std::size_t i = 0; i < scene.images.size(); ++i)
        EXPECT_EQ(freed.at(i), static_cast<int>(i)) << "each once";
    EXPECT_EQ(renderer.render(onDevice, camera).color.texels, whole.color.texels);
}

} // namespace
} // namespace torrance::test
