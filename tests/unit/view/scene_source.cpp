#include "view/scene_source.h"

#include "core/error.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace torrance {
namespace {

void put(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream(file) << text;
}

std::string textOf(const std::filesystem::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

class SceneSourceTest : public testing::Test
{
protected:
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "torrance-scene-source";
    const std::filesystem::path file = folder / "scene.gltf";

    SceneSourceTest()
    {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
        put(file, "first");
    }
    ~SceneSourceTest() override { std::filesystem::remove_all(folder); }
};

TEST_F(SceneSourceTest, KeepsWhatTheFileHeldHoweverOftenItIsWrittenOver)
{
    std::filesystem::path copy;
    {
        SceneSource source(file);
        EXPECT_TRUE(source.copy().empty());
        for (const char* text : {"second", "third"})
            source.writeOver([&](const std::filesystem::path& from) {
                EXPECT_EQ(textOf(from), "first");
                EXPECT_EQ(from.filename(), file.filename()) << "its ending says what it is";
                put(file, text);
            });
        EXPECT_EQ(textOf(file), "third");
        copy = source.copy();
        EXPECT_EQ(textOf(copy), "first");
    }
    EXPECT_FALSE(std::filesystem::exists(copy.parent_path()));
}

TEST_F(SceneSourceTest, WhereWritingFailsTheFileIsStillTheSource)
{
    SceneSource source(file);
    const auto fail = [](const std::filesystem::path&) { throw writeError("it", "is full", ""); };
    EXPECT_THROW(source.writeOver(fail), Error);
    EXPECT_TRUE(source.copy().empty());
    source.writeOver([&](const std::filesystem::path&) { put(file, "second"); });
    EXPECT_THROW(source.writeOver(fail), Error);
    EXPECT_EQ(textOf(source.copy()), "first");
}

TEST_F(SceneSourceTest, DoesNotWriteOverWhatAnotherProgramWrote)
{
    SceneSource source(file);
    source.writeOver([&](const std::filesystem::path&) { put(file, "second"); });
    put(file, "another's");
    try {
        source.writeOver([&](const std::filesystem::path&) { put(file, "third"); });
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::input);
        EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos);
    }
    EXPECT_EQ(textOf(file), "another's");
}

TEST_F(SceneSourceTest, SaysWhereThereIsNoPlaceForTheCopy)
{
    const char* before = std::getenv("TMPDIR");
    const std::string kept = before ? before : "";
    const std::filesystem::path none = folder / "none";
    std::filesystem::create_directories(none);
    setenv("TMPDIR", none.c_str(), 1);
    SceneSource source(folder / "gone.gltf"); // nothing to copy
    EXPECT_THROW(source.writeOver([](const std::filesystem::path&) {}), Error);
    EXPECT_TRUE(std::filesystem::is_empty(none)) << "and leaves no folder behind";
    before ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
}

TEST_F(SceneSourceTest, KnowsItsFileByOtherPaths)
{
    SceneSource source(file);
    EXPECT_TRUE(source.isFile(folder / ".." / folder.filename() / "scene.gltf"));
    EXPECT_FALSE(source.isFile(folder / "other.gltf"));
    EXPECT_FALSE(SceneSource("demo").isFile(file));
}

} // namespace
} // namespace torrance
