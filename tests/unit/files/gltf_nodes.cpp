// The hierarchy, and what stands on nodes: instances, cameras, lights.
#include "gltf_builder.h"

#include <cmath>

namespace torrance {
namespace {

void expectNear(const dvec3& value, const dvec3& expected, double tolerance = 1e-12)
{
    EXPECT_LE(glm::length(value - expected), tolerance) << value.x << " " << value.y << " " << value.z << " where "
                                                        << expected.x << " " << expected.y << " " << expected.z;
}

dvec3 moved(const Instance& instance, const dvec3& point)
{
    return dvec3(instance.worldFromObject * dvec4(point, 1.0));
}

TEST(GltfNodes, ComposeTranslationRotationScale)
{
    GltfBuilder builder = GltfBuilder::triangle();
    // A quarter turn about +Z takes +X to +Y: (1,0,0) is scaled to (2,0,0), turned to (0,2,0), moved to (10,22,30).
    builder.json["nodes"] = {{{"mesh", 0},
                              {"translation", {10, 20, 30}},
                              {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}},
                              {"scale", {2, 3, 4}}}};
    const Scene scene = load(builder).scene;
    expectNear(moved(scene.instances.at(0), dvec3(1, 0, 0)), dvec3(10, 22, 30));
    expectNear(moved(scene.instances.at(0), dvec3(0, 1, 0)), dvec3(7, 20, 30));
    expectNear(moved(scene.instances.at(0), dvec3(0, 0, 1)), dvec3(10, 20, 34));
}

TEST(GltfNodes, ReadMatricesByColumnsAndMultiplyDownTheTree)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["nodes"] = {{{"children", {1}}, {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}},
                             {{"mesh", 0}, {"translation", {1, 0, 0}}}};
    const Instance instance = load(builder).scene.instances.at(0);
    expectNear(moved(instance, dvec3(0.0)), dvec3(5, 7, 7)); // (1,0,0) becomes (0,1,0), then moves
    EXPECT_EQ(instance.object, 1);
}

TEST(GltfNodes, NormaliseRotations)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["nodes"][0]["rotation"] = {0, 0, 2, 2};
    const LoadedScene loaded = load(builder);
    expectNear(moved(loaded.scene.instances.at(0), dvec3(1, 0, 0)), dvec3(0, 1, 0));
    EXPECT_EQ(warningsAbout(loaded, "/nodes/0/rotation: is not of unit length"), 1);
    builder.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
    EXPECT_TRUE(contains(errorOf(builder), "/nodes/0/rotation: is a quaternion without a direction"));
}

TEST(GltfNodes, RefuseMatricesThatAreNoTransforms)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.5, 0, 0, 0, 1};
    EXPECT_TRUE(contains(errorOf(builder), "/nodes/0/matrix: is no affine transform"));
    builder.json["nodes"][0]["matrix"] = {1, 0, 0};
    EXPECT_TRUE(contains(errorOf(builder), "/nodes/0/matrix: has 3 elements where 16 are due"));
    builder.json["nodes"][0]["matrix"] = std::vector<std::string>(16, "1");
    EXPECT_TRUE(contains(errorOf(builder), "/nodes/0/matrix/0: is not a number"));
}

TEST(GltfNodes, NameTheTransformThatOverflows)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["nodes"] = {{{"children", {1}}, {"scale", {1e200, 1, 1}}}, {{"mesh", 0}, {"scale", {1e200, 1, 1}}}};
    EXPECT_TRUE(contains(errorOf(builder), "/nodes/1: has a world transform that overflows"));
}

TEST(GltfNodes, RefuseCyclesAndSecondParents)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["nodes"] = {{{"mesh", 0}, {"children", {0}}}};
    EXPECT_TRUE(contains(errorOf(builder), "/nodes/0: stands in a cycle"));
    builder.json["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
    EXPECT_TRUE(contains(errorOf(builder), "/nodes/1: stands in a cycle"));
    builder.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
    EXPECT_TRUE(contains(errorOf(builder), "/nodes/2: is a child of nodes 0 and 1"));
    builder.json["nodes"] = {{{"children", {1, 1}}}, {{"mesh", 0}}};
    EXPECT_TRUE(contains(errorOf(builder), "/nodes/1: is a child of nodes 0 and 0"));
}

TEST(GltfNodes, RefuseReferencesOutOfRange)
{
    const auto broken = [](auto&& change) {
        GltfBuilder builder = GltfBuilder::triangle();
        change(builder.json);
        return errorOf(builder);
    };
    EXPECT_TRUE(contains(broken([](auto& j) { j["nodes"][0]["mesh"] = 1; }), "/nodes/0/mesh: refers to meshes/1 of 1"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["nodes"][0]["mesh"] = -1; }), "/nodes/0/mesh: is not a whole number"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["nodes"][0]["children"] = {5}; }), "/nodes/0/children/0: refers to"));
    EXPECT_TRUE(
        contains(broken([](auto& j) { j["nodes"][0]["camera"] = 0; }), "/nodes/0/camera: refers to cameras/0 of 0"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["nodes"][0]["skin"] = 0; }), "/nodes/0/skin"));
    EXPECT_TRUE(
        contains(broken([](auto& j) { j["scenes"][0]["nodes"] = {1}; }), "/scenes/0/nodes/0: refers to nodes/1 of 1"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["scene"] = 3; }), "/scene: refers to scenes/3 of 1"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 7; }),
                         "/attributes/POSITION: refers to accessors/7 of 1"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["meshes"][0]["primitives"][0]["material"] = 0; }),
                         "refers to materials/0 of 0"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["meshes"][0]["primitives"][0]["indices"] = 1e30; }), "/indices"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["accessors"][0]["bufferView"] = 1; }), "refers to bufferViews/1 of 1"));
    EXPECT_TRUE(
        contains(broken([](auto& j) { j["bufferViews"][0]["buffer"] = 1; }), "/bufferViews/0/buffer: refers to"));
    EXPECT_TRUE(
        contains(broken([](auto& j) { j["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0; }), "of 0"));
}

TEST(GltfNodes, RefuseWrongTypes)
{
    const auto broken = [](auto&& change) {
        GltfBuilder builder = GltfBuilder::triangle();
        change(builder.json);
        return errorOf(builder);
    };
    EXPECT_TRUE(contains(broken([](auto& j) { j["nodes"] = 3; }), "/nodes: is not an array"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["nodes"][0] = nullptr; }), "/nodes/0: is not an object"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["nodes"][0]["name"] = 3; }), "/nodes/0/name: is not a string"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["nodes"][0]["mesh"] = "0"; }), "/nodes/0/mesh: is not a whole number"));
    EXPECT_TRUE(
        contains(broken([](auto& j) { j["meshes"][0].erase("primitives"); }), "/meshes/0/primitives: is missing"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["meshes"][0]["primitives"][0].erase("attributes"); }),
                         "attributes: is missing"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["accessors"][0].erase("count"); }), "/accessors/0/count: is missing"));
    EXPECT_TRUE(contains(broken([](auto& j) { j["extensionsUsed"] = "KHR_mesh_quantization"; }), "/extensionsUsed"));
    EXPECT_EQ(broken([](auto& j) {
                  j["nodes"][0]["unknown"] = {{"deep", {1, 2, 3}}};
              }),
              "")
        << "unknown properties are ignored";
}

TEST(GltfNodes, WalkAChainOfAnyLength)
{
    constexpr int kLength = 100000;
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["nodes"] = nlohmann::json::array();
    for (int i = 0; i + 1 < kLength; ++i)
        builder.json["nodes"].push_back({{"children", {i + 1}}, {"translation", {1, 0, 0}}});
    builder.json["nodes"].push_back({{"mesh", 0}});
    expectNear(moved(load(builder).scene.instances.at(0), dvec3(0.0)), dvec3(kLength - 1, 0, 0));
}

GltfBuilder twoScenes()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["nodes"] = {{{"mesh", 0}, {"name", "left"}}, {{"mesh", 0}, {"translation", {4, 0, 0}}}};
    builder.json["scenes"] = {{{"nodes", {0}}, {"name", "first"}}, {{"nodes", {1}}, {"name", "second"}}};
    builder.json["scene"] = 1;
    return builder;
}

TEST(GltfNodes, DrawTheDefaultSceneOrTheOneAskedFor)
{
    const GltfBuilder builder = twoScenes();
    EXPECT_EQ(load(builder).scene.name, "second");
    EXPECT_EQ(load(builder).scene.instances.at(0).object, 1);
    EXPECT_EQ(load(builder, {.scene = 0}).scene.instances.at(0).object, 0);
    EXPECT_EQ(load(builder, {.scene = 0}).scene.instances.size(), 1u);

    GltfBuilder noDefault = builder;
    noDefault.json.erase("scene");
    EXPECT_EQ(load(noDefault).scene.name, "first");

    GltfBuilder noScenes = noDefault;
    noScenes.json.erase("scenes");
    const LoadedScene loaded = load(noScenes);
    EXPECT_EQ(loaded.scene.instances.size(), 2u);
    EXPECT_EQ(loaded.facts.scene, -1);
    EXPECT_EQ(warningsAbout(loaded, "has no scenes"), 1);
}

TEST(GltfNodes, BlameTheUserForASceneThatIsNotThere)
{
    for (const int scene : {-1, 2})
        try {
            load(twoScenes(), {.scene = scene});
            FAIL();
        } catch (const Error& error) {
            EXPECT_EQ(error.exitCode, ExitCode::usage);
            EXPECT_TRUE(contains(error.what(), "choose one from 0 to 1")) << error.what();
        }
}

TEST(GltfNodes, PlaceInstances)
{
    GltfBuilder builder = GltfBuilder::triangle();
    const int translation = builder.addFloats({1, 0, 0, 0, 1, 0}, "VEC3");
    // Quarter turns about Z: none, and one whose quaternion is in normalised 16-bit integers.
    const int rotation =
        builder.addAccessor(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 23170, 23170}, gltf::kShort, "VEC4", 2);
    builder.accessor(rotation)["normalized"] = true;
    const int scale = builder.addFloats({1, 1, 1, 3, 3, 3}, "VEC3");
    builder.json["nodes"][0]["translation"] = {0, 0, 10};
    builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", translation}, {"ROTATION", rotation}, {"SCALE", scale}};
    const Scene scene = load(builder).scene;
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.primitives.size(), 1u) << "the geometry is shared";
    expectNear(moved(scene.instances[0], dvec3(1, 0, 0)), dvec3(2, 0, 10));
    expectNear(moved(scene.instances[1], dvec3(1, 0, 0)), dvec3(0, 4, 10));

    builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
        builder.addFloats({1, 1, 1}, "VEC3");
    EXPECT_TRUE(contains(errorOf(builder), "attributes of unequal counts"));
}

TEST(GltfNodes, ReadCameras)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["cameras"] = {
        {{"type", "perspective"},
         {"name", "eye"},
         {"perspective", {{"yfov", 0.7}, {"znear", 0.1}, {"zfar", 50}, {"aspectRatio", 1.5}}}},
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 2}, {"ymag", 1}, {"znear", 0}, {"zfar", 9}}}}};
    builder.json["nodes"] = {
        {{"children", {1, 2}}, {"scale", {2, 5, 3}}},
        {{"camera", 0}, {"translation", {1, 2, 3}}, {"rotation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}}},
        {{"camera", 1}}};
    const std::vector<Camera> cameras = load(builder).scene.cameras;
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[0].name, "eye");
    EXPECT_EQ(cameras[0].kind, Camera::Kind::perspective);
    EXPECT_DOUBLE_EQ(cameras[0].verticalFov, 0.7);
    EXPECT_DOUBLE_EQ(cameras[0].aspect, 1.5);
    EXPECT_DOUBLE_EQ(cameras[0].nearPlane, 0.1);
    EXPECT_DOUBLE_EQ(cameras[0].farPlane, 50.0);
    // A quarter turn about +Y: the camera's back, +Z, points along +X; the scale above it is gone.
    expectNear(dvec3(cameras[0].worldFromCamera[2]), dvec3(1, 0, 0));
    expectNear(dvec3(cameras[0].worldFromCamera[1]), dvec3(0, 1, 0));
    expectNear(dvec3(cameras[0].worldFromCamera[0]), dvec3(0, 0, -1));
    expectNear(dvec3(cameras[0].worldFromCamera[3]), dvec3(2, 10, 9));
    EXPECT_EQ(cameras[1].kind, Camera::Kind::orthographic);
    EXPECT_DOUBLE_EQ(cameras[1].xmag, 2.0);
    EXPECT_DOUBLE_EQ(cameras[1].ymag, 1.0);

    const auto broken = [&](const char* pointer, const nlohmann::json& value) {
        GltfBuilder changed = builder;
        changed.json[nlohmann::json::json_pointer(pointer)] = value;
        return errorOf(changed);
    };
    EXPECT_TRUE(contains(broken("/cameras/0/perspective/yfov", 0), "/cameras/0/perspective: has a yfov"));
    EXPECT_TRUE(contains(broken("/cameras/0/perspective/yfov", 3.2), "has a yfov"));
    EXPECT_TRUE(contains(broken("/cameras/0/perspective/znear", 0), "0 < znear < zfar"));
    EXPECT_TRUE(contains(broken("/cameras/0/perspective/zfar", 0.05), "0 < znear < zfar"));
    EXPECT_TRUE(contains(broken("/cameras/1/orthographic/xmag", 0), "xmag or ymag of 0"));
    EXPECT_TRUE(contains(broken("/cameras/1/orthographic/zfar", 0), "0 <= znear < zfar"));
    EXPECT_TRUE(contains(broken("/cameras/1/type", "fisheye"), "fisheye"));
}

TEST(GltfNodes, GiveLightsARadius)
{
    const auto lightOf = [](const char* type, const nlohmann::json& radius) {
        GltfBuilder builder = GltfBuilder::triangle();
        nlohmann::json light = {{"type", type}, {"extras", {{"radius", radius}, {"maker", "lamp shop"}}}};
        if (light["type"] == "spot")
            light["spot"] = nlohmann::json::object();
        builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {light};
        builder.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
        return builder;
    };
    EXPECT_EQ(load(lightOf("point", 0.25)).scene.lights.at(0).radius, 0.25);
    EXPECT_EQ(load(lightOf("spot", 2)).scene.lights.at(0).radius, 2.0);
    EXPECT_EQ(load(lightOf("point", 0)).scene.lights.at(0).radius, 0.0);
    const LoadedScene sun = load(lightOf("directional", 2));
    EXPECT_EQ(sun.scene.lights.at(0).radius, 0.0);
    EXPECT_EQ(warningsAbout(sun, "lights/0/extras/radius: is of a directional light"), 1);
    EXPECT_TRUE(contains(errorOf(lightOf("point", -1)), "lights/0/extras/radius: is below zero"));
    EXPECT_TRUE(contains(errorOf(lightOf("point", "wide")), "lights/0/extras/radius: is not a number"));
    GltfBuilder remark = lightOf("point", 1);
    remark.json["extensions"]["KHR_lights_punctual"]["lights"][0]["extras"] = "a remark";
    EXPECT_EQ(load(remark).scene.lights.at(0).radius, 0.0) << "extras may be anything";
}

TEST(GltfNodes, ReadLights)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["extensionsUsed"] = {"KHR_lights_punctual"};
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}},
        {{"type", "point"}, {"color", {1, 0.5, 0.25}}, {"intensity", 40}, {"range", 7}, {"name", "bulb"}},
        {{"type", "spot"}, {"spot", nlohmann::json::object()}},
        {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}}};
    const auto on = [](int light) { return nlohmann::json{{"KHR_lights_punctual", {{"light", light}}}}; };
    builder.json["nodes"] = {
        {{"extensions", on(0)}, {"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}, {"scale", {9, 9, 9}}},
        {{"extensions", on(1)}, {"translation", {1, 2, 3}}},
        {{"extensions", on(2)}},
        {{"extensions", on(3)}}};
    builder.json["scenes"] = {{{"nodes", {0, 1, 2, 3}}}};
    const std::vector<Light> lights = load(builder).scene.lights;
    ASSERT_EQ(lights.size(), 4u);
    EXPECT_EQ(lights[0].kind, Light::Kind::directional);
    EXPECT_EQ(lights[0].color, dvec3(1.0));
    EXPECT_EQ(lights[0].intensity, 1.0) << "the default; a node's scale changes nothing";
    expectNear(lights[0].direction, dvec3(0, -1, 0)); // -90 degrees about X takes -Z to -Y
    EXPECT_EQ(lights[1].kind, Light::Kind::point);
    EXPECT_EQ(lights[1].name, "bulb");
    EXPECT_EQ(lights[1].intensity, 40.0);
    EXPECT_EQ(lights[1].range, 7.0);
    EXPECT_EQ(lights[1].color, dvec3(1, 0.5, 0.25));
    EXPECT_EQ(lights[1].position, dvec3(1, 2, 3));
    EXPECT_EQ(lights[2].innerConeAngle, 0.0);
    EXPECT_NEAR(lights[2].outerConeAngle, kPi / 4.0, 1e-9);
    EXPECT_EQ(lights[2].range, 0.0) << "unlimited";
    EXPECT_EQ(lights[3].innerConeAngle, 0.1);
    EXPECT_EQ(lights[3].outerConeAngle, 0.2);

    const auto broken = [&](const char* pointer, const nlohmann::json& value) {
        GltfBuilder changed = builder;
        changed.json["extensions"]["KHR_lights_punctual"]["lights"][nlohmann::json::json_pointer(pointer)] = value;
        return errorOf(changed);
    };
    EXPECT_TRUE(contains(broken("/3/spot/innerConeAngle", 0.2), "lights/3/spot: has cone angles"));
    EXPECT_TRUE(contains(broken("/3/spot/outerConeAngle", 2.0), "lights/3/spot: has cone angles"));
    EXPECT_TRUE(contains(broken("/1/type", "laser"), "lights/1: has the unknown type \"laser\""));
    EXPECT_TRUE(contains(broken("/1/range", -2), "lights/1/range: is not above zero"));
    EXPECT_EQ(broken("/1/intensity", -2), "");
}

} // namespace
} // namespace torrance
