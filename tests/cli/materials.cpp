// Shapes and materials that are chosen on the command line, and OBJ files, as a user gives them.
#include "program.h"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace torrance::test {
namespace {

void expectRefused(const std::vector<std::string>& arguments, int code, const std::vector<std::string>& parts)
{
    const TestFolder folder;
    std::vector<std::string> all = {"render", "-r", "16x16", "-o", folder.file("out.png")};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = runTorrance(all);
    EXPECT_EQ(outcome.exitCode, code) << outcome.errors;
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    for (const std::string& part : parts)
        EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
    EXPECT_TRUE(folder.names().empty()) << "something was left behind";
}

TEST(Materials, APrimitiveIsDrawnInsteadOfAFile)
{
    const TestFolder folder;
    const Outcome outcome = runTorrance({"render", "--primitive", "sphere", "--metallic", "1", "--roughness", "0.3",
                                         "--base-color", "#ffc040", "-r", "32x32", "-o", folder.file("{stem}.png")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"sphere.png"});
}

TEST(Materials, InspectSaysWhatAPrimitiveIs)
{
    const Outcome outcome = runTorrance({"inspect", "--primitive", "cube", "--json", "-"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const auto file = nlohmann::json::parse(outcome.output)["files"][0];
    EXPECT_EQ(file["container"], "primitive");
    EXPECT_EQ(file["drawn"]["triangles"], 12);
}

TEST(Materials, OptionsThatDoNotFitAreRefused)
{
    expectRefused({}, 2, {"no scene was named"});
    expectRefused({"--primitive", "spher"}, 2, {"did you mean sphere?"});
    expectRefused({"demo", "--primitive", "sphere"}, 2, {"--primitive and demo exclude each other"});
    expectRefused({"--primitive", "sphere", "--scene", "0"}, 2, {"--scene and --allow-external are for files"});
    expectRefused({"--primitive", "sphere", "--roughness", "1.5"}, 2, {"--roughness must lie between 0 and 1"});
    expectRefused({"--primitive", "sphere", "--metallic", "nan"}, 2, {"--metallic"});
    expectRefused({"--primitive", "sphere", "--base-color", "red"}, 2, {"--base-color red"});
    expectRefused({"--primitive", "sphere", "--base-color", "1,2,3"}, 2, {"must lie between 0 and 1"});
    expectRefused({"--primitive", "sphere", "--material", "gould"}, 2, {"did you mean gold?"});
    expectRefused({"--primitive", "sphere", "--material", "gold", "--maps", "x"}, 2, {"--material and --maps"});
    expectRefused({"--primitive", "sphere", "--material", "diamond", "--path", "deferred"}, 2,
                  {"the deferred path has no room for the index of refraction of diamond"});
    expectRefused({"--primitive", "sphere", "--maps", "nowhere"}, 3, {"nowhere: no such folder"});
}

TEST(Materials, AFolderWithoutMapsIsRefusedByName)
{
    const TestFolder maps;
    std::ofstream(maps.path / "readme.txt") << "no maps here";
    expectRefused({"--primitive", "plane", "--maps", maps.path.string()}, 3,
                  {maps.path.string() + ": holds no map that is told by its name"});
}

TEST(Materials, AnObjFileIsDrawnAndInspected)
{
    const TestFolder folder;
    std::ofstream(folder.path / "m.mtl") << "newmtl red\nKd 1 0 0\nNs 96\n";
    std::ofstream(folder.path / "m.obj") << "mtllib m.mtl\no sail\nv 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\n"
                                            "usemtl red\nf 1 2 3 4\n";
    EXPECT_EQ(runTorrance({"render", folder.file("m.obj"), "-r", "16x16", "-o", folder.file("m.png")}).exitCode, 0);
    const Outcome inspected = runTorrance({"inspect", folder.file("m.obj")});
    EXPECT_EQ(inspected.exitCode, 0) << inspected.errors;
    for (const char* part : {"  OBJ\n", "sail", "red", "1 instances, 4 vertices, 2 triangles", "1 x 2 x 0 m"})
        EXPECT_NE(inspected.output.find(part), std::string::npos) << inspected.output;
}

TEST(Materials, AMissingMapNamesFileItemAndRemedy)
{
    const TestFolder folder;
    std::ofstream(folder.path / "m.mtl") << "newmtl red\nmap_Kd gone.png\n";
    std::ofstream(folder.path / "m.obj") << "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 2 0\nusemtl red\nf 1 2 3\n";
    expectRefused({folder.file("m.obj")}, 3,
                  {"m.mtl: material red: map_Kd (gone.png): no such file; check the name and the folder"});
}

} // namespace
} // namespace torrance::test
