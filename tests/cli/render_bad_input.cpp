// What `torrance render` says of bad input: the exit code, one line that names the file, and no picture left behind.
// What is wrong with a scene in all its forms is tested in unit/files; here are the ways by which it reaches a user.
#include "files/image_write.h"
#include "program.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace torrance::test {
namespace {

using nlohmann::json;

// The bytes of a glTF buffer: three positions and three indices.
std::string triangleBytes()
{
    const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::uint16_t indices[] = {0, 1, 2};
    std::string bytes(sizeof positions + sizeof indices, '\0');
    std::memcpy(bytes.data(), positions, sizeof positions);
    std::memcpy(bytes.data() + sizeof positions, indices, sizeof indices);
    return bytes;
}

// RFC 4648, section 4.
std::string base64(const std::string& bytes)
{
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text.push_back(i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=');
    }
    return text;
}

// One triangle with a textured material whose image the test may break.
json triangle()
{
    const std::string bytes = triangleBytes();
    return {
        {"asset", {{"version", "2.0"}}},
        {"scene", 0},
        {"scenes", {{{"nodes", {0}}}}},
        {"nodes", {{{"mesh", 0}}}},
        {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
        {"buffers", {{{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}}},
        {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}, {{"buffer", 0}, {"byteOffset", 36}, {"byteLength", 6}}}},
        {"accessors",
         {{{"bufferView", 0},
           {"componentType", 5126},
           {"count", 3},
           {"type", "VEC3"},
           {"min", {0, 0, 0}},
           {"max", {1, 1, 0}}},
          {{"bufferView", 1}, {"componentType", 5123}, {"count", 3}, {"type", "SCALAR"}}}},
    };
}

class RenderBadInput : public ::testing::Test
{
protected:
    std::string write(const std::string& name, const std::string& bytes)
    {
        std::ofstream(folder.file(name), std::ios::binary)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return folder.file(name);
    }

    std::string scene(const json& gltf, const std::string& name = "scene.gltf") { return write(name, gltf.dump()); }

    Outcome render(const std::string& input, const std::vector<std::string>& more = {},
                   const std::vector<std::string>& environment = {})
    {
        std::vector<std::string> arguments = {"render", input, "-o", folder.file("out.png"), "-r", "16x16"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runTorrance(arguments, environment);
    }

    void expectRefused(const Outcome& outcome, int exitCode, const std::string& named)
    {
        EXPECT_EQ(outcome.exitCode, exitCode) << named << ": " << outcome.errors;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
        EXPECT_NE(outcome.errors.find(named), std::string::npos) << outcome.errors;
        EXPECT_FALSE(std::filesystem::exists(folder.file("out.png"))) << named;
        for (const std::string& name : folder.names())
            EXPECT_NE(name.front(), '.') << "a temporary file is left: " << name;
    }

    TestFolder folder;
};

TEST_F(RenderBadInput, FilesThatAreNoScene)
{
    expectRefused(render(folder.file("missing.glb")), 3, "missing.glb");
    expectRefused(render(write("empty.glb", "")), 3, "empty.glb");
    expectRefused(render(write("garbage.glb", std::string(1000, '\x5a'))), 3, "garbage.glb");
    expectRefused(render(write("truncated.gltf", triangle().dump().substr(0, 200))), 3, "truncated.gltf");
    expectRefused(render(folder.path.string()), 3, folder.path.string());
}

TEST_F(RenderBadInput, GlbWithWrongLengths)
{
    std::string glb = "glTF";
    for (const std::uint32_t word : {2u, 1000000u, 2000000u, 0x4e4f534au}) // version, length, chunk length, "JSON"
        glb.append(reinterpret_cast<const char*>(&word), sizeof word);
    expectRefused(render(write("a.glb", glb + "{}")), 3, "a.glb");
}

TEST_F(RenderBadInput, AccessorsAndIndices)
{
    json past = triangle();
    past["accessors"][0]["count"] = 4;
    expectRefused(render(scene(past)), 3, "accessor");
    json huge = triangle();
    huge["accessors"][0]["count"] = 4000000000000ll;
    expectRefused(render(scene(huge)), 3, "accessor");
    json index = triangle();
    std::string bytes = triangleBytes();
    bytes[36] = 9;
    index["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(bytes);
    expectRefused(render(scene(index)), 3, "scene.gltf");
}

TEST_F(RenderBadInput, CyclesInTheNodeTree)
{
    json cycle = triangle();
    cycle["nodes"] = {{{"children", {1}}}, {{"children", {0}}, {"mesh", 0}}};
    expectRefused(render(scene(cycle)), 3, "node");
}

TEST_F(RenderBadInput, ImagesThatAreMissingOrCorrupt)
{
    json textured = triangle();
    textured["meshes"][0]["primitives"][0]["material"] = 0;
    textured["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    textured["textures"] = {{{"source", 0}}};
    textured["images"] = {{{"uri", "bricks.png"}}};
    expectRefused(render(scene(textured)), 3, "bricks.png");
    write("bricks.png", "\x89PNG\r\n\x1a\n and then nothing");
    expectRefused(render(scene(textured)), 3, "bricks.png");
}

TEST_F(RenderBadInput, UrisThatLeaveTheFolder)
{
    const auto withUri = [](const std::string& uri) {
        json outside = triangle();
        outside["buffers"][0]["uri"] = uri;
        return outside;
    };
    for (const char* uri : {"../secret.bin", "/etc/passwd", "%2e%2e/secret.bin"})
        expectRefused(render(scene(withUri(uri))), 3, "--allow-external");
    for (const char* uri : {"http://example.com/a.bin", "file:///etc/passwd"})
        expectRefused(render(scene(withUri(uri))), 3, uri);
}

TEST_F(RenderBadInput, RequiredExtensionsThatAreNotKnown)
{
    json gltf = triangle();
    gltf["extensionsRequired"] = gltf["extensionsUsed"] = {"EXT_of_tomorrow"};
    expectRefused(render(scene(gltf)), 3, "EXT_of_tomorrow");
}

TEST_F(RenderBadInput, Environments)
{
    const std::string input = scene(triangle());
    expectRefused(render(input, {"-e", folder.file("missing.hdr")}), 3, "missing.hdr");
    expectRefused(render(input, {"-e", write("cut.hdr", "#?RADIANCE\n\n-Y 512 +X 1024\n")}), 3, "cut.hdr");
}

TEST_F(RenderBadInput, EnvironmentValuesThatAreNoRadianceAreReplacedAndCounted)
{
    Image panorama(32, 16, 3, 0.5f);
    panorama.texels[7] = std::numeric_limits<float>::quiet_NaN();
    panorama.texels[8] = std::numeric_limits<float>::infinity();
    panorama.texels[9] = -1.0f;
    writePicture(folder.file("broken.exr"), panorama, {}, {});
    const Outcome outcome = render(scene(triangle()), {"--hdri", folder.file("broken.exr")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_NE(outcome.errors.find("3 values"), std::string::npos) << outcome.errors;
    const Outcome check = runTorrance({"compare", folder.file("out.png"), folder.file("out.png")});
    EXPECT_EQ(check.exitCode, 0) << check.errors;
}

TEST_F(RenderBadInput, Resolutions)
{
    const std::string input = scene(triangle());
    for (const char* resolution : {"0x16", "16x0", "-4x16", "100000x100000", "16", "16x16x16", "axb", "1.5x2", "16,"}) {
        const Outcome outcome = runTorrance({"render", input, "-o", folder.file("out.png"), "-r", resolution});
        expectRefused(outcome, 2, "--resolution");
    }
}

TEST_F(RenderBadInput, OutputsThatCannotBe)
{
    const std::string input = scene(triangle());
    expectRefused(runTorrance({"render", input, "-o", folder.file("missing/out.png"), "-r", "16x16"}), 6,
                  "missing/out.png");
    expectRefused(runTorrance({"render", input, "-o", folder.file("out.tga"), "-r", "16x16"}), 2, ".png");
    expectRefused(runTorrance({"render", input, input, "-o", folder.file("out.png"), "-r", "16x16"}), 2, "{stem}");
}

TEST_F(RenderBadInput, FullStandardOutput)
{
    expectRefused(runTorrance({"render", scene(triangle()), "-r", "16x16", "-o", "-"}, {}, "/dev/full"), 6,
                  "standard output");
}

TEST_F(RenderBadInput, OptionsThatAreUnknownOrWrong)
{
    const std::string input = scene(triangle());
    expectRefused(render(input, {"--enviroment", "sky"}), 2, "--environment");
    expectRefused(render(input, {"--tone", "khronos_neutrl"}), 2, "khronos_neutral");
    expectRefused(render(input, {"--preset", "standrad"}), 2, "standard");
    expectRefused(render(input, {"--distribution", "ggz"}), 2, "ggx");
    expectRefused(render(input, {"--samples", "0"}), 2, "--samples");
    expectRefused(render(input, {"--background", "#12345"}), 2, "--background");
    expectRefused(render(input, {"--orbit", "0,nan"}), 2, "--orbit");
}

TEST_F(RenderBadInput, OptionsThatWouldBeIgnored)
{
    const auto refused = [&](const std::string& output, const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"render", "demo", "-r",
                                              "16x16",  "-o",   output == "-" ? output : folder.file(output)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = runTorrance(arguments);
        EXPECT_EQ(outcome.output, "");
        expectRefused(outcome, 2, more.front());
    };
    refused("out.exr", {"--exposure", "1"});
    refused("out.hdr", {"--tone", "agx"});
    refused("out.exr", {"--transfer", "linear"});
    refused("out.png", {"--background-blur", "0.5", "--background", "#102030"});
    refused("out.png", {"--background-blur", "0.5", "--no-background"});
    refused("out.png", {"--background-blur", "1.5"});
    refused("out.png", {"--environment-samples", "16"});
    refused("out.png", {"--light-samples", "16"});
    refused("out.png", {"--environment-samples", "16", "--environment-specular", "split_sum_dominant"});
    const auto refusedMethods = [&](const std::string& text) { refused("out.png", {"--material-methods", text}); };
    for (const char* text :
         {"0", "x:dfg=table", "0:", "0:fresnel=schlick", "0:dfg=tables", "0:dfg", "0:environment-samples=16",
          "0:light-samples=16", "0:environment-specular=vndf,environment-samples=0", "0:dfg=table,dfg=table",
          "0:environment-specular=vndf,environment-samples=1e9", "99:dfg=table"})
        refusedMethods(text);
    refused("out.png", {"--material-methods", "0:dfg=table", "--material-methods", "0:dfg=lazarov"});
    refused("out.png", {"--material-methods", "0:dfg=table", "--preset", "phong"});
    refused("out.png", {"--quality", "50"});
    refused("out.jpg", {"--bits", "16"});
    refused("-", {"--json", "-"});
    refused("out.png", {"--camera-index", "0", "--fov", "30"});
    refused("out.png", {"--margin", "0.1", "--camera-position", "0,0,5"});
    refused("out.png", {"--orbit", "0,90,5", "--margin", "0.1"});
    refused("out.png", {"--environment", "none", "--environment-rotation", "90"});
    EXPECT_TRUE(folder.names().empty());
}

TEST_F(RenderBadInput, NoDevice)
{
    expectRefused(render(scene(triangle()), {}, {"VK_DRIVER_FILES=/dev/null", "VK_ICD_FILENAMES=/dev/null"}), 4,
                  "Vulkan");
    expectRefused(render(scene(triangle()), {"--device", "no such device"}), 4, "no such device");
}

TEST_F(RenderBadInput, ShadersOfAnotherBuild)
{
    namespace fs = std::filesystem;
    fs::create_directory(folder.path / "data");
    for (const auto& entry : fs::directory_iterator(TORRANCE_BINARY_DIR "/share/torrance"))
        if (entry.path().filename() != "shaders")
            fs::create_symlink(entry.path(), folder.path / "data" / entry.path().filename());
    fs::copy(TORRANCE_SOURCE_DIR "/shaders", folder.path / "data" / "shaders", fs::copy_options::recursive);
    const std::vector<std::string> environment = {"TORRANCE_DATA=" + folder.file("data")};
    EXPECT_EQ(render("demo", {}, environment).exitCode, 0) << "as they are";
    fs::remove(folder.file("out.png"));
    std::ofstream(folder.path / "data" / "shaders" / "shared" / "frame.h", std::ios::app) << "// newer\n";
    expectRefused(render("demo", {}, environment), 2, "shared/frame.h: is not what this program was built with");
}

} // namespace
} // namespace torrance::test
