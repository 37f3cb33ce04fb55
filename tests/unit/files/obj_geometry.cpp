// Statements and geometry of OBJ files.
#include "gltf_builder.h"
#include "image/srgb.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

LoadedScene loadText(const std::string& text, const LoadOptions& options = {})
{
    const TestFolder folder;
    return loadScene(folder.write("model.obj", text), options);
}

std::string errorOfText(const std::string& text, const LoadOptions& options = {})
{
    const TestFolder folder;
    return errorOf(folder.write("model.obj", text), options);
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, ATriangle)
{
    const LoadedScene loaded = loadText("v 0 0 0\nv 2 0 0\nv 0 0 -1\nf 1 2 3\n");
    EXPECT_TRUE(loaded.warnings.empty());
    ASSERT_EQ(loaded.scene.primitives.size(), 1u);
    const Primitive& p = loaded.scene.primitives[0];
    EXPECT_EQ(p.positions, (std::vector<vec3>{{0, 0, 0}, {2, 0, 0}, {0, 0, -1}}));
    EXPECT_EQ(p.normals, (std::vector<vec3>(3, vec3(0, 1, 0)))) << "flat, counter-clockwise is the front";
    EXPECT_EQ(p.indices, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_TRUE(p.uvs[0].empty());
    EXPECT_EQ(p.boundsMax, dvec3(2, 0, 0));
    ASSERT_EQ(loaded.scene.instances.size(), 1u);
    EXPECT_EQ(loaded.facts.container, "OBJ");
    EXPECT_EQ(loaded.facts.triangles, 1u);
}

TEST(Obj, EveryFormOfACorner)
{
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt .25 .75\nvn 0 0 2\n";
    for (const char* face : {"f 1/1/1 2/1/1 3/1/1", "f -3/-1/-1 -2/-1/-1 -1/-1/-1", "f 1/1/-1 2/1/-1 3/1/-1"}) {
        const Primitive p = loadText(vertices + face).scene.primitives.at(0);
        EXPECT_EQ(p.uvs[0], (std::vector<vec2>(3, vec2(0.25f, 0.25f)))) << "v runs down here, up there: " << face;
        EXPECT_EQ(p.normals, (std::vector<vec3>(3, vec3(0, 0, 1)))) << face;
    }
    EXPECT_TRUE(loadText(vertices + "f 1//1 2//1 3//1").scene.primitives.at(0).uvs[0].empty());
    EXPECT_EQ(loadText(vertices + "f 1/1 2/1 3/1").scene.primitives.at(0).uvs[0].size(), 3u);
    EXPECT_EQ(loadText(vertices + "f 1/ 2/ 3/").scene.primitives.at(0).positions.size(), 3u);
    EXPECT_EQ(loadText(vertices + "f 1/1/ 2/1/ 3/1/").scene.primitives.at(0).uvs[0].size(), 3u);
}

TEST(Obj, LinesOfEveryKind)
{
    const Primitive unix = loadText(kSquare + "f 1 2 3 4\n").scene.primitives.at(0);
    for (const std::string& text : {std::string("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4"),
                                    std::string("v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r"),
                                    "# made by hand\n\n  " + kSquare + "\tf\t1 2 \\\n 3 4 # a square\n",
                                    std::string("v +0 0.0 0e5\nv 1. 0 -0\nv 1E0 10e-1 0\nv .0 1 0\nf 1 2 3 4\n")})
    {
        const Primitive p = loadText(text).scene.primitives.at(0);
        EXPECT_EQ(p.positions, unix.positions);
        EXPECT_EQ(p.indices, unix.indices);
    }
}

TEST(Obj, SmoothingGroupsShareNormalsAndOffDoesNot)
{
    // A roof: two squares at a right angle that share the edge 2-3.
    const std::string roof = "v -1 0 1\nv 0 1 1\nv 0 1 -1\nv -1 0 -1\nv 1 0 1\nv 1 0 -1\n";
    const std::string faces = "f 1 2 3 4\nf 2 5 6 3\n";
    const float half = std::sqrt(0.5f);
    const Primitive smooth = loadText(roof + "s 3\n" + faces).scene.primitives.at(0);
    EXPECT_EQ(smooth.positions.size(), 6u);
    EXPECT_NEAR(smooth.normals.at(1).y, 1.0f, 1e-6f) << "on the ridge: the mean of both";
    EXPECT_NEAR(smooth.normals.at(0).x, -half, 1e-6f);
    const Primitive flat = loadText(roof + "s 3\ns off\n" + faces).scene.primitives.at(0);
    EXPECT_EQ(flat.positions.size(), 8u) << "an edge of two groups is two edges";
    EXPECT_NEAR(flat.normals.at(1).x, -half, 1e-6f);
    const Primitive apart = loadText(roof + "s 1\nf 1 2 3 4\ns 2\nf 2 5 6 3\n").scene.primitives.at(0);
    EXPECT_EQ(apart.positions.size(), 8u);
    EXPECT_NEAR(apart.normals.at(1).x, -half, 1e-6f);
}

TEST(Obj, NormalsAreWeighedByArea)
{
    // At vertex 1 meet a triangle of area 3/2 facing +Z and one of area 1/2 facing +X.
    const Primitive p = loadText("v 0 0 0\nv 3 0 0\nv 0 1 0\nv 0 0 1\ns 1\nf 1 2 3\nf 1 3 4\n").scene.primitives.at(0);
    EXPECT_NEAR(p.normals.at(0).z / p.normals.at(0).x, 3.0f, 1e-5f);
}

TEST(Obj, SmoothingDoesNotEndAtAMaterial)
{
    const LoadedScene loaded = loadText("v -1 0 1\nv 0 1 1\nv 0 1 -1\nv -1 0 -1\nv 1 0 1\nv 1 0 -1\n"
                                        "s 1\nusemtl a\nf 1 2 3 4\nusemtl b\nf 2 5 6 3\n");
    ASSERT_EQ(loaded.scene.primitives.size(), 2u);
    EXPECT_NEAR(loaded.scene.primitives[1].normals.at(0).y, 1.0f, 1e-6f);
}

TEST(Obj, ShapesAndMaterialsAreParted)
{
    const LoadedScene loaded =
        loadText(kSquare + "o box\nusemtl red paint\nf 1 2 3\nusemtl blue\nf 1 3 4\nusemtl red paint\nf 2 3 4\n"
                           "g lid\nf 1 2 4\no empty\no box\nf 1 2 4\n");
    std::vector<std::string> names;
    for (const Primitive& p : loaded.scene.primitives)
        names.push_back(p.name);
    EXPECT_EQ(names, (std::vector<std::string>{"box red paint", "box blue", "box lid red paint"}));
    EXPECT_EQ(loaded.scene.primitives[0].indices.size(), 9u) << "the same shape and material, wherever they stand";
    EXPECT_EQ(loaded.facts.meshes.names, (std::vector<std::string>{"box", "box lid"}));
    EXPECT_EQ(loaded.facts.materials.names, (std::vector<std::string>{"red paint", "blue"}));
    EXPECT_NE(loaded.scene.instances[0].object, loaded.scene.instances[2].object);
}

TEST(Obj, LargePolygonsAreWhole)
{
    std::string text;
    std::string face = "f";
    for (int i = 0; i < 1000; ++i) {
        text += "v " + std::to_string(std::cos(i * 2.0 * kPi / 1000.0)) + " " +
                std::to_string(std::sin(i * 2.0 * kPi / 1000.0)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    EXPECT_EQ(loadText(text + face).facts.triangles, 998u);
}

TEST(Obj, VertexColoursAreSrgb)
{
    const Primitive p = loadText("v 0 0 0 1 0 0.5\nv 1 0 0 0 1 0.5\nv 0 1 0 0 0 0.5\nf 1 2 3\n").scene.primitives.at(0);
    ASSERT_EQ(p.colors.size(), 3u);
    EXPECT_EQ(p.colors[0].r, 1.0f);
    EXPECT_NEAR(p.colors[0].b, srgbDecode(0.5), 1e-6);
    EXPECT_TRUE(loadText("v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").scene.primitives.at(0).colors.empty())
        << "some vertices have none";
}

TEST(Obj, WhatIsLeftOutIsSaid)
{
    const LoadedScene loaded = loadText(kSquare + "f 1 2 3\nf 1 2\nl 1 2\ncstype bspline\nhello world\nhello again\n");
    EXPECT_EQ(warningsAbout(loaded, "fewer than three corners"), 1);
    EXPECT_EQ(warningsAbout(loaded, "lines or points"), 1);
    EXPECT_EQ(warningsAbout(loaded, "\"cstype\""), 1);
    EXPECT_EQ(warningsAbout(loaded, "line 9: is the first of 2 lines"), 1);
    EXPECT_EQ(loaded.facts.triangles, 1u);
}

TEST(Obj, NumbersThatAreNoneBecomeZeroAndAreCounted)
{
    const LoadedScene loaded = loadText("v 0 0 nan\nv 1 0 1e999\nv 0 1 -inf\nf 1 2 3\nv 1e-999 0 0\n");
    EXPECT_EQ(warningsAbout(loaded, "3 numbers that are NaN or infinite"), 1);
    for (const vec3& position : loaded.scene.primitives.at(0).positions)
        EXPECT_EQ(position.z, 0.0f);
}

TEST(Obj, DamageIsNamedByItsLine)
{
    EXPECT_TRUE(contains(errorOfText("v 0 0\nf 1 1 1\n"), "line 1: v has 2 numbers"));
    EXPECT_TRUE(contains(errorOfText("v 0 0 zero\nf 1 1 1\n"), "line 1: \"zero\" is no number"));
    EXPECT_TRUE(contains(errorOfText("v 0 0 0\nf 1 1 2\n"), "line 2: refers to v 2 of 1"));
    EXPECT_TRUE(contains(errorOfText("v 0 0 0\nf 1 1 -2\n"), "line 2: refers to v -2, of 1 so far"));
    EXPECT_TRUE(contains(errorOfText("v 0 0 0\nf 1/1 1/1 1/1\n"), "refers to vt 1 of 0"));
    EXPECT_TRUE(contains(errorOfText("v 0 0 0\nf 1 1 0\n"), "\"0\" is no index"));
    EXPECT_TRUE(contains(errorOfText("v 0 0 0\nf 1 1 1/1/1/1\n"), "is no corner"));
    EXPECT_TRUE(contains(errorOfText("v 0 0 0\nf 1 1 99999999999999999999\n"), "is no index"));
    EXPECT_TRUE(contains(errorOfText("v 0 0 0\nf 1 1 9223372036854775807\n"), "refers to v 9223372036854775807"));
    EXPECT_TRUE(contains(errorOfText("v 0 0 0\nf 1 1 -9223372036854775808\n"), "so far"));
    EXPECT_TRUE(contains(errorOfText("v 0 0 0\ns one\nf 1 1 1\n"), "line 2: \"s one\" is no smoothing group"));
    EXPECT_TRUE(contains(errorOfText(""), "holds no face"));
    EXPECT_TRUE(contains(errorOfText(std::string(1000, '\0')), "holds no face"));
}

TEST(Obj, LimitsHold)
{
    LoadOptions options;
    options.limits.vertices = 3;
    EXPECT_TRUE(
        contains(errorOfText(kSquare + "f 1 2 3\n", options), "line 4: brings the file to more than 3 vertices"));
    options.limits = {};
    options.limits.indices = 6;
    EXPECT_TRUE(contains(errorOfText(kSquare + "f 1 2 3\nf 1 2 3 4\n", options), "more than 6 corners"));
    options.limits = {};
    options.limits.vertices = 5; // flat faces share nothing
    EXPECT_TRUE(contains(errorOfText(kSquare + "f 1 2 3\nf 1 3 4\n", options), "more than 5 vertices"));
}

TEST(Obj, HasNoScenesToChooseFrom)
{
    const TestFolder folder;
    const auto path = folder.write("model.OBJ", kSquare + "f 1 2 3\n");
    EXPECT_EQ(loadScene(path).facts.triangles, 1u) << "in any case of letters";
    try {
        loadScene(path, {.scene = 0});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::usage);
    }
}

} // namespace
} // namespace torrance
