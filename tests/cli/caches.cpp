// The caches as a user meets them: a second run finds everything, `torrance warm` fills them beforehand, and whatever
// is wrong with them costs time and at most one warning, never the picture.
#include "program.h"

#include <csignal>
#include <fstream>
#include <future>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <thread>

namespace torrance::test {
namespace {

namespace fs = std::filesystem;

/// Cheap to draw, and what the first scene of kScenes is made of.
const std::vector<std::string> kPlane = {"--primitive", "plane", "--metallic", "1",
                                         "--roughness", "1",     "--path",     "attributes"};

const std::vector<std::string> kTextured = {"demo"};

class Caches : public ::testing::Test
{
protected:
    Outcome render(const std::string& picture, const std::vector<std::string>& what = kPlane,
                   const std::string& cacheHome = "", const std::function<void(int)>& meanwhile = {}) const
    {
        std::vector<std::string> arguments = {"render"};
        arguments.insert(arguments.end(), what.begin(), what.end());
        for (const std::string& word : {std::string("-r"), std::string("32x32"), std::string("--json"),
                                        folder.file(picture + ".json"), std::string("-o"), folder.file(picture)})
            arguments.push_back(word);
        return runTorrance(arguments, {"XDG_CACHE_HOME=" + (cacheHome.empty() ? home() : cacheHome)}, "", meanwhile);
    }

    Outcome warm() const
    {
        return runTorrance({"warm", "--only", kScenes, "--json", folder.file("warm.json")},
                           {"XDG_CACHE_HOME=" + home()});
    }

    nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(contentOf(folder.file(name))); }

    std::string home() const { return folder.file("home"); }

    /// Files below the caches and their contents, those of one folder alone where `part` names it; without Mesa's
    /// index, which changes with use.
    std::map<fs::path, std::string> files(const std::string& part = "") const
    {
        std::map<fs::path, std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(home()))
            if (entry.is_regular_file() && entry.path().filename() != "index" &&
                entry.path().string().find(part) != std::string::npos)
                found.emplace(entry.path(), contentOf(entry.path()));
        return found;
    }

    /// Draws with caches that `damage` was done to: the same picture, and nothing said.
    void stillDraws(const std::function<void()>& damage, const std::vector<std::string>& what = kPlane)
    {
        ASSERT_EQ(render("good.png", what).exitCode, 0);
        damage();
        const Outcome outcome = render("again.png", what);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        EXPECT_EQ(outcome.errors, "");
        EXPECT_EQ(contentOf(folder.file("again.png")), contentOf(folder.file("good.png")));
    }

    /// The second half of each file below a part of the caches.
    void spoil(const std::string& part) const
    {
        for (const auto& [path, content] : files(part)) {
            std::string damaged = content;
            for (std::size_t at = damaged.size() / 2; at < damaged.size(); at += 7)
                damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
            std::ofstream(path, std::ios::binary) << damaged;
        }
    }

    static constexpr const char* kDriver = "mesa_shader_cache/";
    static constexpr const char* kTextures = "/textures/";
    static constexpr const char* kPictures = "/pictures/";
    static constexpr const char* kScenes = "dense, one"; // of one material
    TestFolder folder;
};

TEST_F(Caches, ASecondRunCompilesNothing)
{
    ASSERT_EQ(render("a.png").exitCode, 0);
    const auto before = files();
    EXPECT_FALSE(files(kDriver).empty()) << "the driver keeps nothing: the test would see nothing";
    ASSERT_EQ(render("b.png").exitCode, 0);
    EXPECT_TRUE(files() == before);
    EXPECT_GT(json("a.png.json")["shaders_compiled"], 0);
    EXPECT_EQ(json("b.png.json")["shaders_compiled"], 0);
    EXPECT_EQ(contentOf(folder.file("a.png")), contentOf(folder.file("b.png")));
}

TEST_F(Caches, WhatIsWarmIsLeftAsItIs)
{
    ASSERT_EQ(warm().exitCode, 0);
    EXPECT_FALSE(json("warm.json")["was_warm"]);
    const auto before = files();
    ASSERT_EQ(warm().exitCode, 0);
    EXPECT_TRUE(json("warm.json")["was_warm"]);
    EXPECT_EQ(json("warm.json")["driver_files_added"], 0);
    EXPECT_TRUE(files() == before);
}

TEST_F(Caches, AModelNeverDrawnCompilesNothingOnceWarm)
{
    ASSERT_EQ(warm().exitCode, 0);
    const auto before = files(kDriver);
    ASSERT_FALSE(before.empty());
    ASSERT_EQ(render("a.png").exitCode, 0);
    EXPECT_TRUE(files(kDriver) == before);
    EXPECT_EQ(json("a.png.json")["shaders_compiled"], 0);
}

TEST_F(Caches, WhatIsMissingIsFilledAgain)
{
    ASSERT_EQ(warm().exitCode, 0);
    const auto before = files(kDriver);
    fs::remove(before.begin()->first);
    ASSERT_EQ(warm().exitCode, 0);
    EXPECT_FALSE(json("warm.json")["was_warm"]);
    EXPECT_EQ(files(kDriver).size(), before.size());
}

TEST_F(Caches, WarmNeedsAFolderThatItCanWrite)
{
    std::ofstream(home()) << "not a folder";
    const Outcome outcome = warm();
    EXPECT_EQ(outcome.exitCode, 6);
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    EXPECT_NE(outcome.errors.find("XDG_CACHE_HOME"), std::string::npos) << outcome.errors;
    EXPECT_EQ(runTorrance({"warm", "--no-cache"}).exitCode, 2);
}

TEST_F(Caches, AFolderThatCannotBeWrittenIsWarnedOfOnce)
{
    std::ofstream(folder.file("file")) << "not a folder";
    ASSERT_EQ(render("good.png").exitCode, 0);
    const Outcome outcome = render("a.png", kPlane, folder.file("file"));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    EXPECT_NE(outcome.errors.find("cache"), std::string::npos) << outcome.errors;
    EXPECT_EQ(contentOf(folder.file("a.png")), contentOf(folder.file("good.png")));
}

TEST_F(Caches, AFullDiskIsWarnedOfOnce)
{
    ASSERT_EQ(render("good.png").exitCode, 0);
    // A file that grows beyond the limit fails to, as on a full disk: the picture is smaller, an environment larger.
    rlimit before = {};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small = {.rlim_cur = 8192, .rlim_max = before.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN); // inherited
    setrlimit(RLIMIT_FSIZE, &small);
    const Outcome outcome = render("a.png", kPlane, folder.file("other"));
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    EXPECT_NE(outcome.errors.find("cache"), std::string::npos) << outcome.errors;
    EXPECT_EQ(contentOf(folder.file("a.png")), contentOf(folder.file("good.png")));
}

TEST_F(Caches, DamagedFilesAreMadeAnew)
{
    stillDraws([&] { spoil(""); });
}

TEST_F(Caches, ASecondRunDecodesNoPicture)
{
    ASSERT_EQ(render("a.png", kTextured).exitCode, 0);
    ASSERT_EQ(render("b.png", kTextured).exitCode, 0);
    EXPECT_GT(json("a.png.json")["pictures_decoded"], 3);
    EXPECT_EQ(json("b.png.json")["pictures_decoded"], 0);
    EXPECT_EQ(contentOf(folder.file("a.png")), contentOf(folder.file("b.png")));
    ASSERT_EQ(render("c.png", {"demo", "--no-cache"}).exitCode, 0);
    EXPECT_EQ(contentOf(folder.file("a.png")), contentOf(folder.file("c.png")));
}

// What is certified is compared with the texels, which are decoded whatever the caches hold.
TEST_F(Caches, ACertifiedPictureIsThatOfTheFile)
{
    const std::vector<std::string> certified = {"demo", "--certify", "16"};
    ASSERT_EQ(render("a.png", kTextured).exitCode, 0);
    ASSERT_EQ(render("b.png", certified).exitCode, 0);
    EXPECT_EQ(json("b.png.json")["pictures_decoded"], json("a.png.json")["pictures_decoded"]);
    EXPECT_EQ(contentOf(folder.file("a.png")), contentOf(folder.file("b.png")));
}

TEST_F(Caches, AnotherViewReadsThePicturesAgainWhereItNeedsOtherLevels)
{
    const std::vector<std::string> near = {"demo", "--orbit", "20,70,0.4"};
    ASSERT_EQ(render("far.png", kTextured).exitCode, 0);
    ASSERT_EQ(render("near.png", near).exitCode, 0);
    EXPECT_GT(json("near.png.json")["pictures_decoded"], 0);
    ASSERT_EQ(render("fresh.png", near, folder.file("other")).exitCode, 0);
    EXPECT_EQ(contentOf(folder.file("near.png")), contentOf(folder.file("fresh.png")));
    ASSERT_EQ(render("again.png", near).exitCode, 0);
    EXPECT_EQ(json("again.png.json")["pictures_decoded"], 0);
}

TEST_F(Caches, AMaterialFromTheCommandLineIsNotTakenForTheFiles)
{
    const std::vector<std::string> mapped = {
        "demo", "--maps", std::string(TORRANCE_BINARY_DIR) + "/share/torrance/assets/maps/worn_copper"};
    ASSERT_EQ(render("demo.png", kTextured).exitCode, 0);
    ASSERT_EQ(render("maps.png", mapped).exitCode, 0);
    ASSERT_EQ(render("fresh.png", mapped, folder.file("other")).exitCode, 0);
    EXPECT_EQ(contentOf(folder.file("maps.png")), contentOf(folder.file("fresh.png")));
}

TEST_F(Caches, DamagedTexturesAreMadeAnew)
{
    for (const char* part : {kTextures, kPictures}) {
        stillDraws([&] { spoil(part); }, kTextured);
        EXPECT_GT(json("again.png.json")["pictures_decoded"], 0) << part;
    }
}

TEST_F(Caches, TexturesThatMadeRoomAreMadeAnew)
{
    stillDraws([&] { fs::remove(files(kTextures).begin()->first); }, kTextured);
    EXPECT_GT(json("again.png.json")["pictures_decoded"], 0);
}

TEST_F(Caches, TruncatedFilesAreMadeAnew)
{
    stillDraws([&] {
        for (const auto& [path, content] : files())
            fs::resize_file(path, content.size() / 2);
    });
}

TEST_F(Caches, FilesOfAnotherBuildAreNotTrusted)
{
    // The head of ours says its layout's version, and that of Mesa's which driver wrote it.
    stillDraws([&] {
        for (const auto& [path, content] : files()) {
            std::string other = content;
            for (std::size_t at = 4; at < std::min<std::size_t>(other.size(), 24); ++at)
                other[at] = static_cast<char>(other[at] + 1);
            std::ofstream(path, std::ios::binary) << other;
        }
    });
}

TEST_F(Caches, TwoProcessesFillThemAtOnce)
{
    auto other = std::async(std::launch::async, [&] { return render("b.png"); });
    const Outcome one = render("a.png");
    const Outcome two = other.get();
    for (const Outcome& outcome : {one, two}) {
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        EXPECT_EQ(outcome.errors, "");
    }
    EXPECT_EQ(contentOf(folder.file("a.png")), contentOf(folder.file("b.png")));
    const auto before = files();
    ASSERT_EQ(render("c.png").exitCode, 0);
    EXPECT_TRUE(files() == before) << "between them they left all that is needed";
}

TEST_F(Caches, AProcessThatIsKilledWhileFillingThemHarmsNothing)
{
    const auto killOnceItFills = [&](int process) {
        const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (std::chrono::steady_clock::now() < limit && (!fs::exists(home()) || files(kDriver).empty()))
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        kill(process, SIGKILL);
    };
    EXPECT_EQ(render("killed.png", kPlane, "", killOnceItFills).exitCode, 128 + SIGKILL);
    EXPECT_FALSE(fs::exists(folder.file("killed.png")));
    ASSERT_EQ(render("a.png").exitCode, 0);
    const Outcome fresh = render("b.png", kPlane, folder.file("other"));
    ASSERT_EQ(fresh.exitCode, 0);
    EXPECT_EQ(contentOf(folder.file("a.png")), contentOf(folder.file("b.png")));
}

} // namespace
} // namespace torrance::test
