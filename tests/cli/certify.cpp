// `torrance render --certify` and `torrance verify` as a user meets them.
#include "files/exr_file.h"
#include "files/image_read.h"
#include "program.h"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace torrance::test {
namespace {

class Certify : public ::testing::Test
{
protected:
    void put(const std::string& name, const std::string& content)
    {
        std::ofstream(folder.file(name), std::ios::binary) << content;
    }
    /// A small certified picture of a sphere.
    void render(const std::string& name, const std::string& certify = "--certify=32")
    {
        const Outcome outcome = runTorrance({"render", "--primitive", "sphere", "--roughness", "0.4", "--metallic", "1",
                                             "-r", "48x48", "-o", folder.file(name), certify});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    }
    void expectRefused(const std::vector<std::string>& arguments, int code, const std::string& why)
    {
        const Outcome outcome = runTorrance(arguments);
        EXPECT_EQ(outcome.exitCode, code) << why << ": " << outcome.errors;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
        EXPECT_NE(outcome.errors.find(why), std::string::npos) << outcome.errors;
    }
    Outcome verify(const std::string& name) { return runTorrance({"verify", folder.file(name)}); }

    /// The picture with a block of pixels changed by `change`, its header as it was.
    void changeBlock(const std::string& from, const std::string& to, float change)
    {
        const ReadImage read = readImage(folder.file(from));
        ImageLayer layer{"", {"R", "G", "B", "A"}, read.image};
        for (int y = 20; y < 28; ++y)
            for (int x = 20; x < 28; ++x)
                layer.image.at(x, y)[1] += change;
        const std::vector<std::byte> bytes = encodeExr(std::span(&layer, 1), {});
        put(to, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }

    TestFolder folder;
};

TEST_F(Certify, WritesTheSameBytesEachTimeAndVerifiesThem)
{
    render("a.exr");
    const std::string picture = folder.content("a.exr"), certificate = folder.content("a.exr.certificate.json");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "a.exr.certificate.json"}));
    EXPECT_EQ(verify("a.exr").exitCode, 0);
    render("a.exr");
    EXPECT_EQ(folder.content("a.exr"), picture);
    EXPECT_EQ(folder.content("a.exr.certificate.json"), certificate);
    const auto json = nlohmann::json::parse(certificate);
    EXPECT_EQ(json["sample"]["compared"], 32);
    EXPECT_EQ(json["image"]["non_finite_pixels"], 0);
    EXPECT_EQ(json["yardstick"], "model");
    EXPECT_EQ(json["plan"]["methods"]["environment_specular"], "split_sum");
    const auto& mean = json["shading"]["mean"];
    EXPECT_LE(mean["low"].get<double>(), mean["value"].get<double>());
    EXPECT_LE(mean["value"].get<double>(), mean["high"].get<double>());
    EXPECT_NE(json["not_vouched_for"].dump().find("sampling"), std::string::npos);
}

TEST_F(Certify, HoldsInTheHeaderAloneAndInAMovedFolder)
{
    render("a.exr");
    std::filesystem::remove(folder.file("a.exr.certificate.json"));
    EXPECT_EQ(verify("a.exr").exitCode, 0);
    std::filesystem::create_directory(folder.file("elsewhere"));
    std::filesystem::rename(folder.file("a.exr"), folder.file("elsewhere/b.exr"));
    EXPECT_EQ(verify("elsewhere/b.exr").exitCode, 0);
}

TEST_F(Certify, VerifiesPicturesThatHoldCodes)
{
    for (const char* name : {"a.png", "a.jpg", "a.hdr"}) {
        render(name);
        const Outcome outcome = verify(name);
        EXPECT_EQ(outcome.exitCode, 0) << name << outcome.errors;
        std::string bytes = folder.content(name);
        bytes.back() = static_cast<char>(bytes.back() + 1);
        put(name, bytes);
        EXPECT_EQ(verify(name).exitCode, 1) << name;
    }
}

TEST_F(Certify, AChangedBlockOfPixelsFails)
{
    render("a.exr");
    changeBlock("a.exr", "b.exr", 0.0f); // written anew, nothing changed
    put("b.exr.certificate.json", folder.content("a.exr.certificate.json"));
    EXPECT_EQ(verify("b.exr").exitCode, 0);
    changeBlock("a.exr", "b.exr", 0.01f);
    expectRefused({"verify", folder.file("b.exr")}, 1, "hash differs");
    // Nor does it hold with another's certificate, nor where numbers were touched up.
    auto json = nlohmann::json::parse(folder.content("a.exr.certificate.json"));
    json["shading"]["mean"]["value"] = json["shading"]["mean"]["value"].get<double>() * 0.9;
    put("a.exr.certificate.json", json.dump());
    expectRefused({"verify", folder.file("a.exr")}, 1, "shading mean value");
}

TEST_F(Certify, AnotherSceneFails)
{
    render("a.exr");
    auto json = nlohmann::json::parse(folder.content("a.exr.certificate.json"));
    for (auto& argument : json["scene"]["arguments"])
        if (argument == "--roughness=0.4")
            argument = "--roughness=0.41";
    put("a.exr.certificate.json", json.dump());
    expectRefused({"verify", folder.file("a.exr")}, 1, "the scene is not the one");
    expectRefused({"verify", folder.file("a.exr"), "-e", "sky"}, 1, "the scene is not the one");
    expectRefused({"verify", folder.file("a.exr"), "--model", "demo"}, 2, "--model");
}

TEST_F(Certify, RefusesCertificatesThatAreNone)
{
    render("a.png");
    const std::string file = "a.png.certificate.json", good = folder.content(file);
    put(file, good.substr(0, good.size() / 2));
    expectRefused({"verify", folder.file("a.png")}, 3, file);
    put(file, "{}");
    expectRefused({"verify", folder.file("a.png")}, 3, "format");
    auto earlier = nlohmann::json::parse(good);
    earlier["format"] = "torrance certificate 1"; // whose truths were drawn otherwise
    put(file, earlier.dump());
    expectRefused({"verify", folder.file("a.png")}, 3, "made by another version");
    for (const char* part : {"image", "scene", "sample", "shading", "worst"}) {
        auto json = nlohmann::json::parse(good);
        json.erase(part);
        put(file, json.dump());
        expectRefused({"verify", folder.file("a.png")}, 3, part);
    }
    auto json = nlohmann::json::parse(good);
    json["scene"]["arguments"].push_back("--no-such-option");
    put(file, json.dump());
    expectRefused({"verify", folder.file("a.png")}, 3, "arguments");
    json = nlohmann::json::parse(good);
    json["pixels"][0] = "999999 0 0 0 0";
    put(file, json.dump());
    expectRefused({"verify", folder.file("a.png")}, 3, "/pixels/0");
    std::filesystem::remove(folder.file(file));
    expectRefused({"verify", folder.file("a.png")}, 3, "--certify");
    expectRefused({"verify", folder.file("none.png")}, 3, "none.png");
}

TEST_F(Certify, RefusesWhatCannotBeCertified)
{
    const auto refused = [&](std::vector<std::string> more, int code, const std::string& why) {
        std::vector<std::string> arguments = {"render", "--primitive", "sphere", "-r", "16x16"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expectRefused(arguments, code, why);
    };
    const std::string out = folder.file("a.exr");
    for (const char* wrong : {"0", "-5", "15", "1048577", "99999999999999999999", "1.5", "half", "512,"})
        refused({"-o", out, std::string("--certify=") + wrong}, 2, "--certify");
    refused({"-o", out, "--certify=transprt"}, 2, "--certify=512,noise=1%,sampling,transport");
    refused({"-o", out, "--certify=transport", "--preset", "phong", "-e", "none"}, 2, "no BRDF");
    refused({"-o", "-", "--certify"}, 2, "standard output");
    refused({"-o", out, "--view", "F", "--certify"}, 2, "--view");
    refused({"-o", out, "--camera-position", "0,0,5", "--target", "0,0,9", "--certify"}, 2, "no surface is seen");
    // A blurred background has no exact value where it is part of a pixel that is compared: of several samples, behind
    // the demo's glass, in the other parts.
    refused({"-o", out, "--background-blur", "0.5", "--samples", "4", "--certify"}, 2, "--background-blur");
    refused({"-o", out, "--background-blur", "0.5", "--certify=sampling"}, 2, "--background-blur");
    expectRefused({"render", "demo", "-r", "16x16", "-o", out, "--background-blur", "0.5", "--certify"}, 2,
                  "--background-blur");
    expectRefused({"render", "demo", "-r", "16x16", "-o", out, "--samples", "4", "--pixel-sampling", "reconstructed",
                   "--certify"},
                  2, "--samples 1");
    EXPECT_TRUE(folder.names().empty());
}

TEST_F(Certify, KnowsTheTruthsAsWellAsItIsAsked)
{
    render("a.exr", "--certify=32,noise=10%");
    render("b.exr", "--certify=32,noise=0.01");
    const auto noiseIn = [&](const char* name) {
        const auto json = nlohmann::json::parse(folder.content(std::string(name) + ".certificate.json"));
        EXPECT_EQ(json["sample"]["asked_noise"], name[0] == 'a' ? 0.1 : 0.01);
        return json["sample"]["noise"].get<double>();
    };
    // Even points do better than the root of their number, and spreads of 16 estimates are known to a fifth.
    EXPECT_LT(noiseIn("a.exr"), 0.12);
    EXPECT_LT(noiseIn("b.exr"), 0.012);
    EXPECT_EQ(verify("b.exr").exitCode, 0);
    const std::string out = folder.file("c.exr");
    for (const char* bad : {"noise=0", "noise=60%", "noise=few", "noise="})
        expectRefused({"render", "demo", "-r", "16x16", "-o", out, std::string("--certify=") + bad}, 2, "noise");
}

TEST_F(Certify, AddsThePartOfSampling)
{
    render("a.exr", "--certify=128,sampling");
    const auto json = nlohmann::json::parse(folder.content("a.exr.certificate.json"));
    EXPECT_GT(json["sampling"]["mean"]["low"].get<double>(), 0.0) << "one sample at a silhouette";
    EXPECT_EQ(json["not_vouched_for"].dump().find("sampling"), std::string::npos);
    EXPECT_EQ(verify("a.exr").exitCode, 0);
}

TEST_F(Certify, AddsThePartOfTransport)
{
    const Outcome outcome =
        runTorrance({"render", "demo", "-r", "48x48", "-o", folder.file("a.exr"), "--certify=32,transport", "--quiet"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const auto json = nlohmann::json::parse(folder.content("a.exr.certificate.json"));
    EXPECT_GT(json["transport"]["mean"]["low"].get<double>(), 0.01)
        << "the demo's things stand on a table, in its light";
    EXPECT_EQ(json["not_vouched_for"].dump().find("transport"), std::string::npos);
    EXPECT_FALSE(json.contains("sampling"));
    EXPECT_EQ(verify("a.exr").exitCode, 0);
    std::string text = folder.content("a.exr.certificate.json");
    const std::size_t place = text.find("\"value\"", text.find("\"transport\": {"));
    ASSERT_NE(place, std::string::npos);
    text.insert(text.find(':', place) + 2, "1"); // another number
    std::ofstream(folder.file("a.exr.certificate.json")) << text;
    EXPECT_EQ(verify("a.exr").exitCode, 1);
}

// What a material computes in its own way is recorded, and drawn again.
TEST_F(Certify, RecordsTheMethodsOfMaterials)
{
    const auto drawn = [&](const std::string& name, std::vector<std::string> more) {
        more.insert(more.begin(), {"render", "--primitive", "sphere", "--roughness", "0.4", "--metallic", "1", "-r",
                                   "48x48", "-o", folder.file(name), "--certify=32", "--explain"});
        const Outcome outcome = runTorrance(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        return outcome.output;
    };
    const std::string explained =
        drawn("a.exr", {"--material-methods", "0:environment-specular=vndf_bounded,environment-samples=16"});
    const std::string text = "0:environment-diffuse=irradiance_cube,environment-specular=vndf_bounded,dfg=table,"
                             "area-light=point,environment-samples=16";
    EXPECT_NE(explained.find("  of material " + text + "\n"), std::string::npos) << explained;
    const auto json = nlohmann::json::parse(folder.content("a.exr.certificate.json"));
    EXPECT_EQ(json["plan"]["of_materials"], nlohmann::json::array({text}));
    EXPECT_EQ(verify("a.exr").exitCode, 0);
    drawn("b.exr", {"--environment-specular", "vndf_bounded", "--environment-samples", "16"});
    EXPECT_EQ(readImage(folder.file("a.exr")).image.texels, readImage(folder.file("b.exr")).image.texels);
    drawn("c.exr", {});
    EXPECT_NE(readImage(folder.file("a.exr")).image.texels, readImage(folder.file("c.exr")).image.texels);
}

// The worst pixel's error is put down to the method that drew its material.
TEST_F(Certify, FindsTheCauseInTheMethodsOfTheMaterial)
{
    const auto causeOf = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"render", "--primitive", "sphere", "--roughness", "0.4", "--metallic", "1", "-r",
                                   "48x48", "-o", folder.file("a.exr"), "--certify=32"});
        const Outcome outcome = runTorrance(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        return nlohmann::json::parse(folder.content("a.exr.certificate.json"))["worst"]["cause"];
    };
    const auto own =
        causeOf({"--environment-specular", "vndf_bounded", "--material-methods", "0:environment-specular=split_sum"});
    EXPECT_EQ(own["method"], "split_sum");
    EXPECT_EQ(own, causeOf({"--environment-specular", "split_sum"}));
}

} // namespace
} // namespace torrance::test
