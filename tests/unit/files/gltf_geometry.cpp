// Mesh primitives: modes, attributes, normals, morph targets, skins.
#include "gltf_builder.h"

#include "files/gltf_topology.h"

#include <cmath>

namespace torrance {
namespace {

using Indices = std::vector<std::uint32_t>;

const float kHalf = std::sqrt(0.5f);

// glTF 2.0, 3.7.2.1, with five vertices a to e = 0 to 4.
TEST(GltfGeometry, UnrollsEveryMode)
{
    const Indices five = {0, 1, 2, 3, 4};
    EXPECT_EQ(unrolled(0, five), five);
    EXPECT_EQ(unrolled(1, five), (Indices{0, 1, 2, 3}));
    EXPECT_EQ(unrolled(2, five), (Indices{0, 1, 1, 2, 2, 3, 3, 4, 4, 0}));
    EXPECT_EQ(unrolled(3, five), (Indices{0, 1, 1, 2, 2, 3, 3, 4}));
    EXPECT_EQ(unrolled(4, five), (Indices{0, 1, 2}));
    EXPECT_EQ(unrolled(5, five), (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
    EXPECT_EQ(unrolled(6, five), (Indices{1, 2, 0, 2, 3, 0, 3, 4, 0}));
}

TEST(GltfGeometry, KnowsTheUnrolledCountBeforehand)
{
    for (int mode = 0; mode < kGltfModes; ++mode)
        for (std::size_t count = 0; count < 12; ++count)
            EXPECT_EQ(unrolled(mode, Indices(count, 0u)).size(), unrolledCount(mode, count)) << mode << " " << count;
}

TEST(GltfGeometry, LoadsEveryModeAndRefusesOthers)
{
    const Topology expected[] = {Topology::points,    Topology::lines,     Topology::lines,    Topology::lines,
                                 Topology::triangles, Topology::triangles, Topology::triangles};
    for (int mode = 0; mode < kGltfModes; ++mode) {
        GltfBuilder builder = GltfBuilder::triangle();
        builder.primitive()["mode"] = mode;
        const Primitive primitive = load(builder).scene.primitives.at(0);
        EXPECT_EQ(primitive.topology, expected[mode]) << mode;
        EXPECT_EQ(primitive.indices.size(), unrolledCount(mode, 3)) << mode;
        EXPECT_EQ(primitive.normals.empty(), mode < 4) << "points and lines without normals stay without: " << mode;
    }
    GltfBuilder builder = GltfBuilder::triangle();
    builder.primitive()["mode"] = 7;
    EXPECT_TRUE(contains(errorOf(builder), "/meshes/0/primitives/0: has the unknown mode 7"));
}

TEST(GltfGeometry, RefusesIndicesPastTheVerticesAndOfWrongTypes)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.primitive()["indices"] =
        builder.addAccessor(std::vector<std::uint16_t>{0, 1, 3}, gltf::kUnsignedShort, "SCALAR", 3);
    EXPECT_TRUE(contains(errorOf(builder), "/meshes/0/primitives/0/indices: refer to vertex 3 of 3 at 2"));
    builder.primitive()["indices"] =
        builder.addAccessor(std::vector<std::uint16_t>{0, 1, 65535}, gltf::kUnsignedShort, "SCALAR", 3);
    EXPECT_TRUE(contains(errorOf(builder), "refer to vertex 65535")) << "glTF has no primitive restart";
    builder.primitive()["indices"] = builder.addFloats({0, 1, 2}, "SCALAR");
    EXPECT_TRUE(contains(errorOf(builder), "/indices: are not scalars of an unsigned"));
    builder.primitive()["indices"] = builder.addAccessor(std::vector<std::int16_t>{0, 1, 2}, gltf::kShort, "SCALAR", 3);
    EXPECT_TRUE(contains(errorOf(builder), "/indices: are not scalars of an unsigned"));
}

TEST(GltfGeometry, RefusesAttributesOfUnequalLengthAndWrongFormat)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.primitive()["attributes"]["NORMAL"] = builder.addFloats({0, 0, 1, 0, 0, 1}, "VEC3");
    EXPECT_TRUE(contains(errorOf(builder), "/NORMAL: has 2 elements where POSITION has 3"));
    builder = GltfBuilder::triangle();
    builder.primitive()["attributes"]["COLOR_0"] =
        builder.addAccessor(std::vector<std::uint8_t>(12), gltf::kUnsignedByte, "VEC4", 3);
    EXPECT_TRUE(contains(errorOf(builder), "/COLOR_0: has a format")) << "colours of integers are normalised";
    builder = GltfBuilder::triangle();
    builder.primitive()["attributes"]["_TEMPERATURE"] = builder.addFloats({1, 2}, "SCALAR");
    EXPECT_EQ(errorOf(builder), "") << "attributes of an application's own are its own";
}

TEST(GltfGeometry, LeavesOutWhatDrawsNothing)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.primitive()["attributes"].erase("POSITION");
    LoadedScene loaded = load(builder);
    EXPECT_TRUE(loaded.scene.primitives.empty());
    EXPECT_EQ(warningsAbout(loaded, "has no positions"), 1);

    builder = GltfBuilder::triangle();
    builder.primitive()["indices"] =
        builder.addAccessor(std::vector<std::uint16_t>{0, 1}, gltf::kUnsignedShort, "SCALAR", 2);
    loaded = load(builder);
    EXPECT_TRUE(loaded.scene.primitives.empty());
    EXPECT_EQ(warningsAbout(loaded, "too few vertices"), 1);
}

TEST(GltfGeometry, ReadsEveryAttribute)
{
    GltfBuilder builder = GltfBuilder::triangle();
    auto& attributes = builder.primitive()["attributes"];
    const int normal = builder.addFloats({0, 0, 2, 0, 1, 0, 3, 0, 0}, "VEC3");
    const int tangent = builder.addFloats({2, 0, 0, 1, 0, 0, 1, -1, 0, 1, 0, -0.5f}, "VEC4");
    const int uv0 = builder.addFloats({0, 1, 2, 3, 4, 5}, "VEC2");
    const int uv1 = builder.addFloats({5, 4, 3, 2, 1, 0}, "VEC2");
    const int color = builder.addFloats({.1f, .2f, .3f, .4f, .5f, .6f, .7f, .8f, .9f}, "VEC3");
    attributes["NORMAL"] = normal;
    attributes["TANGENT"] = tangent;
    attributes["TEXCOORD_0"] = uv0;
    attributes["TEXCOORD_1"] = uv1;
    attributes["COLOR_0"] = color;
    const Primitive primitive = load(builder).scene.primitives.at(0);
    EXPECT_EQ(primitive.normals, (std::vector<vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}})) << "of unit length";
    EXPECT_EQ(primitive.tangents, (std::vector<vec4>{{1, 0, 0, 1}, {0, 0, 1, -1}, {0, 1, 0, -1}}));
    EXPECT_EQ(primitive.uvs[0][1], vec2(2, 3));
    EXPECT_EQ(primitive.uvs[1][1], vec2(3, 2));
    EXPECT_EQ(primitive.colors[1], vec4(.4f, .5f, .6f, 1.0f)) << "three components: alpha is one";
    EXPECT_EQ(primitive.boundsMin, dvec3(0.0));
    EXPECT_EQ(primitive.boundsMax, dvec3(1.0, 1.0, 0.0));
}

TEST(GltfGeometry, MakesFlatNormalsWhereThereAreNone)
{
    GltfBuilder builder;
    const int position = builder.addFloats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3");
    const int uv = builder.addFloats({0, 0, 1, 0, 0, 1, 1, 1}, "VEC2");
    const int tangent = builder.addFloats({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4");
    const int indices =
        builder.addAccessor(std::vector<std::uint16_t>{0, 1, 2, 0, 3, 1}, gltf::kUnsignedShort, "SCALAR", 6);
    builder.setPrimitive(
        {{"attributes", {{"POSITION", position}, {"TEXCOORD_0", uv}, {"TANGENT", tangent}}}, {"indices", indices}});
    const Primitive primitive = load(builder).scene.primitives.at(0);
    EXPECT_EQ(primitive.indices, (Indices{0, 1, 2, 3, 4, 5})) << "corners are not shared";
    // (1,0,0) x (0,1,0) = +Z; (0,0,1) x (1,0,0) = +Y.
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(primitive.normals.at(i), i < 3 ? vec3(0, 0, 1) : vec3(0, 1, 0)) << i;
    EXPECT_EQ(primitive.positions.at(4), vec3(0, 0, 1));
    EXPECT_EQ(primitive.uvs[0].at(4), vec2(1, 1));
    EXPECT_TRUE(primitive.tangents.empty()) << "tangents without normals are ignored";
}

TEST(GltfGeometry, GivesDegenerateTrianglesAFiniteNormal)
{
    GltfBuilder builder;
    const int position = builder.addFloats({1, 1, 1, 1, 1, 1, 1, 1, 1}, "VEC3");
    builder.setPrimitive({{"attributes", {{"POSITION", position}}}});
    EXPECT_EQ(load(builder).scene.primitives.at(0).normals, std::vector<vec3>(3, vec3(0, 0, 1)));
}

TEST(GltfGeometry, ComputesNormalsThatHaveNoDirection)
{
    GltfBuilder builder = GltfBuilder::triangle();
    const float nan = std::nanf("");
    builder.primitive()["attributes"]["NORMAL"] = builder.addFloats({1, 0, 0, 0, 0, 0, nan, nan, nan}, "VEC3");
    const LoadedScene loaded = load(builder);
    EXPECT_EQ(loaded.scene.primitives.at(0).normals, (std::vector<vec3>{{1, 0, 0}, {0, 0, 1}, {0, 0, 1}}));
    EXPECT_EQ(warningsAbout(loaded, "2 normals of no direction"), 1);
}

TEST(GltfGeometry, DropsTangentsThatHaveNoDirection)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.primitive()["attributes"]["NORMAL"] = builder.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    builder.primitive()["attributes"]["TANGENT"] = builder.addFloats({1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1}, "VEC4");
    const LoadedScene loaded = load(builder);
    EXPECT_TRUE(loaded.scene.primitives.at(0).tangents.empty());
    EXPECT_EQ(warningsAbout(loaded, "tangents of no direction"), 1);
}

TEST(GltfGeometry, ReadsQuantizedAttributes)
{
    GltfBuilder builder;
    const int position = builder.addAccessor(std::vector<std::int16_t>{0, 0, 0, 0, 100, 0, 0, 0, 0, -200, 0, 0},
                                             gltf::kShort, "VEC3", 3);
    builder.view(0)["byteStride"] = 8;
    const int normal = builder.addAccessor(std::vector<std::int8_t>{0, 0, 127, 0, 0, -127, 0, 0, 90, 90, 0, 0},
                                           gltf::kByte, "VEC3", 3);
    builder.view(1)["byteStride"] = 4;
    builder.accessor(normal)["normalized"] = true;
    builder.setPrimitive({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}});
    LoadedScene loaded = load(builder);
    EXPECT_EQ(warningsAbout(loaded, "does not declare KHR_mesh_quantization"), 2);
    builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    loaded = load(builder);
    EXPECT_TRUE(loaded.warnings.empty());
    const Primitive& primitive = loaded.scene.primitives.at(0);
    EXPECT_EQ(primitive.positions, (std::vector<vec3>{{0, 0, 0}, {100, 0, 0}, {0, -200, 0}}))
        << "not normalised: as they stand";
    EXPECT_EQ(primitive.normals[0], vec3(0, 0, 1));
    EXPECT_NEAR(primitive.normals[2].x, kHalf, 1e-7f) << "made unit after dequantisation";
    EXPECT_NEAR(primitive.normals[2].y, kHalf, 1e-7f);
}

GltfBuilder morphed()
{
    GltfBuilder builder = GltfBuilder::triangle();
    const int raise = builder.addFloats({0, 0, 4, 0, 0, 0, 0, 0, 0}, "VEC3");
    const int shift = builder.addFloats({1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3");
    builder.primitive()["targets"] = {{{"POSITION", raise}}, {{"POSITION", shift}}};
    return builder;
}

TEST(GltfGeometry, AppliesMorphTargetsAtRest)
{
    GltfBuilder builder = morphed();
    EXPECT_EQ(load(builder).scene.primitives.at(0).positions[0], vec3(0, 0, 0)) << "no weights: none";
    builder.json["meshes"][0]["weights"] = {0.5, 2.0};
    EXPECT_EQ(load(builder).scene.primitives.at(0).positions, (std::vector<vec3>{{2, 0, 2}, {3, 0, 0}, {2, 1, 0}}));
    builder.json["nodes"][0]["weights"] = {0.25, 0.0};
    const Primitive primitive = load(builder).scene.primitives.at(0);
    EXPECT_EQ(primitive.positions[0], vec3(0, 0, 1)) << "the node's weights replace the mesh's";
    // Corners (0,0,1) (1,0,0) (0,1,0): the normal of the flat triangle is (1,1,1)/sqrt(3), after morphing.
    EXPECT_NEAR(primitive.normals[0].x, 1.0f / std::sqrt(3.0f), 1e-6f);
    EXPECT_EQ(primitive.boundsMax, dvec3(1.0, 1.0, 1.0));
}

TEST(GltfGeometry, KeepsTheSameMeshApartInDifferentPoses)
{
    GltfBuilder builder = morphed();
    builder.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}}, {{"mesh", 0}, {"weights", {1.0, 0.0}}}};
    builder.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
    const Scene scene = load(builder).scene;
    ASSERT_EQ(scene.instances.size(), 3u);
    EXPECT_EQ(scene.primitives.size(), 2u);
    EXPECT_EQ(scene.instances[0].primitive, scene.instances[1].primitive);
    EXPECT_NE(scene.instances[0].primitive, scene.instances[2].primitive);
}

TEST(GltfGeometry, RefusesMorphTargetsThatDoNotFit)
{
    GltfBuilder builder = morphed();
    builder.json["meshes"][0]["weights"] = {0.5};
    EXPECT_TRUE(contains(errorOf(builder), "has 2 morph targets where 1 weights are given"));
    builder = morphed();
    builder.json["meshes"][0]["weights"] = {0.5, 0.5};
    builder.primitive()["targets"][1]["POSITION"] = builder.addFloats({1, 0, 0}, "VEC3");
    EXPECT_TRUE(contains(errorOf(builder), "/targets/1/POSITION: has 1 elements"));
    builder = morphed();
    builder.json["meshes"][0]["weights"] = {0.5, 1e300};
    EXPECT_TRUE(contains(errorOf(builder), "overflows when its morph targets are added"));
}

/// The triangle under two joints: the first stands still, the second moves by +2 Z and doubles.
GltfBuilder skinned(const std::vector<float>& weights, const std::vector<std::uint8_t>& jointNumbers)
{
    GltfBuilder builder = GltfBuilder::triangle();
    const int joints = builder.addAccessor(jointNumbers, gltf::kUnsignedByte, "VEC4", 3);
    const int weight = builder.addFloats(weights, "VEC4");
    builder.primitive()["attributes"]["JOINTS_0"] = joints;
    builder.primitive()["attributes"]["WEIGHTS_0"] = weight;
    builder.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 100, 100}}},
                             {{"children", {2}}},
                             {{"translation", {0, 0, 2}}, {"scale", {2, 2, 2}}}};
    builder.json["scenes"] = {{{"nodes", {0, 1}}}};
    builder.json["skins"] = {{{"joints", {1, 2}}}};
    return builder;
}

TEST(GltfGeometry, AppliesSkinsAtRest)
{
    const GltfBuilder builder = skinned({1, 0, 0, 0, .5f, .5f, 0, 0, 0, 3, 0, 0}, {0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
    const Scene scene = load(builder).scene;
    // Vertex 0: joint 0. Vertex 1: the mean of (1,0,0) and (2,0,2). Vertex 2: joint 1, its weight of 3 made 1.
    EXPECT_EQ(scene.primitives.at(0).positions, (std::vector<vec3>{{0, 0, 0}, {1.5f, 0, 1}, {0, 2, 2}}));
    EXPECT_EQ(scene.instances.at(0).worldFromObject, dmat4(1.0)) << "the node's own transform is ignored";
}

TEST(GltfGeometry, AppliesInverseBindMatrices)
{
    GltfBuilder builder = skinned({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0});
    const std::vector<float> shifted = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -5, 0, 0, 1};
    std::vector<float> matrices = shifted;
    matrices.insert(matrices.end(), shifted.begin(), shifted.end());
    builder.json["skins"][0]["inverseBindMatrices"] = builder.addFloats(matrices, "MAT4");
    // The last vertex, (0, 1, 0), is moved by -5 X before joint 1 doubles it.
    EXPECT_EQ(load(builder).scene.primitives.at(0).positions, (std::vector<vec3>{{-5, 0, 0}, {-4, 0, 0}, {-10, 2, 2}}));
    builder.json["skins"][0]["inverseBindMatrices"] = builder.addFloats(shifted, "MAT4");
    EXPECT_TRUE(contains(errorOf(builder), "/skins/0: does not have a float matrix"));
}

TEST(GltfGeometry, SkinsNormalsByTheInverseTranspose)
{
    GltfBuilder builder = skinned({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
    builder.json["nodes"][2]["scale"] = {1, 4, 1};
    builder.primitive()["attributes"]["NORMAL"] = builder.addFloats({1, 1, 0, 1, 1, 0, 1, 1, 0}, "VEC3");
    // A plane x + y = c stretched by 4 in y: x + y/4 = c, normal (4, 1)/sqrt(17).
    const vec3 normal = load(builder).scene.primitives.at(0).normals[0];
    EXPECT_NEAR(normal.x, 4.0f / std::sqrt(17.0f), 1e-6f);
    EXPECT_NEAR(normal.y, 1.0f / std::sqrt(17.0f), 1e-6f);
    builder.json["nodes"][2]["scale"] = {-1, 4, 1};
    EXPECT_NEAR(load(builder).scene.primitives.at(0).normals[0].x, -4.0f / std::sqrt(17.0f), 1e-6f) << "mirrored";
}

TEST(GltfGeometry, RefusesJointsThatTheSkinDoesNotHave)
{
    const std::vector<float> weights = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    EXPECT_TRUE(contains(errorOf(skinned(weights, {2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})), "by joint 2 of a skin of 2"));
    EXPECT_EQ(errorOf(skinned(weights, {0, 9, 9, 9, 0, 9, 9, 9, 0, 9, 9, 9})), "") << "a weight of zero names no joint";
    EXPECT_EQ(errorOf(skinned(std::vector<float>(12, 0.0f), {9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})), "");
    GltfBuilder builder = skinned(weights, std::vector<std::uint8_t>(12));
    builder.primitive()["attributes"].erase("JOINTS_0");
    EXPECT_TRUE(contains(errorOf(builder), "has no JOINTS_0"));
    builder = skinned(weights, std::vector<std::uint8_t>(12));
    builder.primitive()["attributes"].erase("WEIGHTS_0");
    EXPECT_TRUE(contains(errorOf(builder), "no weights for it"));
}

} // namespace
} // namespace torrance
