#include "program.h"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace torrance::test {
namespace {

std::string write(const TestFolder& folder, const std::string& name, const nlohmann::json& document)
{
    std::ofstream(folder.path / name) << document;
    return folder.file(name);
}

/// A triangle of 1 x 2 m whose buffer is a data URI: (0,0,0) (1,0,0) (0,2,0), little-endian floats.
nlohmann::json triangle()
{
    return {{"asset", {{"version", "2.0"}, {"generator", "hand"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0}}, {"name", "stage"}}}},
            {"nodes", {{{"mesh", 0}}}},
            {"meshes", {{{"name", "sail"}, {"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}}},
            {"accessors", {{{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}}}},
            {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}}},
            {"buffers",
             {{{"byteLength", 36},
               {"uri", "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAEAAAAAA"}}}}};
}

TEST(Inspect, SaysWhatAFileHolds)
{
    const TestFolder folder;
    nlohmann::json document = triangle();
    document["extensionsUsed"] = {"KHR_lights_punctual", "KHR_moon_dust"};
    const Outcome outcome = runTorrance({"inspect", write(folder, "sail.gltf", document)});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    for (const char* part :
         {"made by hand", "scene 0: 1 instances, 3 vertices, 1 triangles", "sail", "stage", "1 x 2 x 0 m",
          "KHR_lights_punctual (used, supported)", "KHR_moon_dust (used, not supported)", "warning"})
        EXPECT_NE(outcome.output.find(part), std::string::npos) << part << "\n" << outcome.output;
}

TEST(Inspect, PrintsNoControlCharacterOfAName)
{
    const TestFolder folder;
    nlohmann::json document = triangle();
    document["meshes"][0]["name"] = "bell\a and escape\x1b[31m";
    document["extensionsUsed"] = {"EXT_\x1b]0;title"};
    const Outcome outcome = runTorrance({"inspect", write(folder, "sail.gltf", document)});
    EXPECT_EQ(outcome.output.find_first_of("\a\x1b"), std::string::npos);
    EXPECT_NE(outcome.output.find("bell? and escape?[31m"), std::string::npos) << outcome.output;
}

TEST(Inspect, WritesJson)
{
    const TestFolder folder;
    const std::string file = write(folder, "sail.gltf", triangle());
    const auto json = nlohmann::json::parse(runTorrance({"inspect", file, "--json", "-"}).output);
    const auto& facts = json.at("files").at(0);
    EXPECT_EQ(facts.at("file"), file);
    EXPECT_EQ(facts.at("container"), "glTF");
    EXPECT_EQ(facts.at("meshes"), nlohmann::json({"sail"}));
    EXPECT_EQ(facts.at("drawn").at("triangles"), 1);
    EXPECT_EQ(facts.at("drawn").at("bufferBytes"), 36);
    EXPECT_EQ(facts.at("drawn").at("boundsMax"), nlohmann::json({1.0, 2.0, 0.0}));
    EXPECT_FALSE(facts.contains("error"));
}

TEST(Inspect, SaysWhatAFileNeedsThatCannotBeDrawn)
{
    const TestFolder folder;
    nlohmann::json document = triangle();
    document["extensionsUsed"] = document["extensionsRequired"] = {"KHR_moon_dust"};
    const std::string file = write(folder, "moon.gltf", document);
    const Outcome outcome = runTorrance({"inspect", file, write(folder, "sail.gltf", triangle())});
    EXPECT_EQ(outcome.exitCode, 3);
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    EXPECT_NE(outcome.errors.find("KHR_moon_dust"), std::string::npos);
    EXPECT_NE(outcome.output.find("KHR_moon_dust (required, not supported)"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("sail.gltf"), std::string::npos) << "the other file is looked at all the same";
}

TEST(Inspect, EndsWithTheCodeOfWhatWentWrong)
{
    const TestFolder folder;
    const std::string file = write(folder, "sail.gltf", triangle());
    EXPECT_EQ(runTorrance({"inspect"}).exitCode, 2);
    EXPECT_EQ(runTorrance({"inspect", file, "--scene", "7"}).exitCode, 2);
    EXPECT_EQ(runTorrance({"inspect", folder.file("none.glb")}).exitCode, 3);
    EXPECT_EQ(runTorrance({"inspect", folder.path.string()}).exitCode, 3);
    EXPECT_EQ(runTorrance({"inspect", file, "--json", folder.file("no/such/folder.json")}).exitCode, 6);
}

TEST(Inspect, LeavesTheFolderOfTheModelOnlyWhenTold)
{
    const TestFolder folder;
    std::filesystem::create_directory(folder.path / "model");
    std::ofstream(folder.path / "data.bin") << std::string(36, '\0');
    nlohmann::json document = triangle();
    document["buffers"][0]["uri"] = "../data.bin";
    const std::string file = write(folder, "model/sail.gltf", document);
    const Outcome refused = runTorrance({"inspect", file});
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_NE(refused.errors.find("--allow-external"), std::string::npos) << refused.errors;
    EXPECT_EQ(runTorrance({"inspect", file, "--allow-external"}).exitCode, 0);
}

} // namespace
} // namespace torrance::test
