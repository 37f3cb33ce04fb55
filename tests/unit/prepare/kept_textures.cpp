#include "prepare/kept_textures.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace torrance {
namespace {

constexpr std::size_t kTexelBytes = 4;

PlannedTexture planned(int width, int height)
{
    PlannedTexture texture{.width = width, .height = height};
    texture.channels[0] = {0, 0};
    texture.channels[1] = {1, 2};
    return texture;
}

/// Levels of 5 x 3 texels, whose rows are a texel further apart than they are long, but for the first level, which has
/// no memory, as nobody reads it.
struct Levels
{
    std::vector<std::vector<std::byte>> storage;
    std::vector<LevelMemory> memory = {{}};

    explicit Levels(int first)
    {
        for (const auto& [width, height] : {std::pair(2, 1), std::pair(1, 1)}) {
            const std::size_t pitch = (static_cast<std::size_t>(width) + 1) * kTexelBytes;
            std::vector<std::byte>& level = storage.emplace_back(pitch * static_cast<std::size_t>(height));
            for (std::byte& value : level)
                value = static_cast<std::byte>(first++);
            memory.push_back({level.data(), pitch});
        }
    }
    bool sameTexels(const Levels& other) const
    {
        return std::equal(storage[0].begin(), storage[0].begin() + 2 * kTexelBytes, other.storage[0].begin()) &&
               std::equal(storage[1].begin(), storage[1].begin() + kTexelBytes, other.storage[1].begin());
    }
};

class KeptTexturesTest : public ::testing::Test
{
protected:
    ~KeptTexturesTest() override { std::filesystem::remove_all(folder); }

    std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("torrance-kept-textures-" + std::to_string(getpid()));
};

TEST_F(KeptTexturesTest, FindWhatWasKeptOfAPicture)
{
    const ContentHash encoded = hashText("encoded");
    const KeptTextures::Picture picture = {.image = {640, 480, TexelFormat::rgba16},
                                           .facts = {.least = {0, 0.25, 0.5, 1}, .greatest = {1, 0.5, 0.5, 1}}};
    {
        KeptTextures first(folder);
        EXPECT_FALSE(first.find(encoded));
        first.keep(encoded, picture);
    }
    KeptTextures second(folder);
    EXPECT_FALSE(second.find(hashText("other")));
    const auto found = second.find(encoded);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->image, picture.image);
    EXPECT_EQ(found->facts.least, picture.facts.least);
    EXPECT_EQ(found->facts.greatest, picture.facts.greatest);
    std::filesystem::remove_all(folder);
    EXPECT_TRUE(second.find(encoded)) << "who was told so once may count on it";
    EXPECT_FALSE(KeptTextures({}).find(encoded));
}

TEST_F(KeptTexturesTest, GiveBackLevelsRowByRow)
{
    KeptTextures kept(folder);
    const ContentHash key = hashText("key");
    const Levels made(1);
    kept.keepLevels(key, planned(5, 3), kTexelBytes, made.memory);
    Levels read(100);
    EXPECT_FALSE(kept.readLevels(hashText("other"), planned(5, 3), kTexelBytes, read.memory));
    ASSERT_TRUE(kept.readLevels(key, planned(5, 3), kTexelBytes, read.memory));
    EXPECT_TRUE(read.sameTexels(made));
    EXPECT_EQ(read.storage[1].back(), Levels(100).storage[1].back()) << "between rows nothing is written";
    EXPECT_FALSE(kept.readLevels(key, planned(9, 3), kTexelBytes, read.memory)) << "of another size";
    EXPECT_FALSE(kept.readLevels(key, planned(5, 3), kTexelBytes, std::span(read.memory).first(2))) << "not all";
}

TEST_F(KeptTexturesTest, TheKeyIsOfAllThatLevelsAreMadeFrom)
{
    const std::vector<ContentHash> pictures = {hashText("a"), hashText("b")};
    const PlannedTexture texture = planned(64, 32);
    const auto key = levelsKey(texture, pictures, 1);
    ASSERT_TRUE(key);
    EXPECT_EQ(levelsKey(texture, pictures, 1), key);
    EXPECT_FALSE(levelsKey(texture, {}, 1)) << "pictures that come from nowhere";
    EXPECT_NE(levelsKey(texture, pictures, 2), key);
    EXPECT_NE(levelsKey(texture, std::vector{hashText("a"), hashText("c")}, 1), key);
    const auto differs = [&](auto&& change) {
        PlannedTexture other = texture;
        change(other);
        EXPECT_NE(levelsKey(other, pictures, 1), key);
    };
    differs([](PlannedTexture& t) { t.content = TexelContent::normal; });
    differs([](PlannedTexture& t) { t.weighByAlpha = true; });
    differs([](PlannedTexture& t) { t.lengthInAlpha = true; });
    differs([](PlannedTexture& t) { t.sampler.mip = MipFilter::none; });
    differs([](PlannedTexture& t) { t.channels[1].channel = 1; });
    differs([](PlannedTexture& t) { std::swap(t.channels[0], t.channels[1]); });
    differs([](PlannedTexture& t) { t.width = 32; });
    differs([](PlannedTexture& t) { t.height = 64; });
    PlannedTexture sampledOtherwise = texture;
    sampledOtherwise.sampler.wrapS = Wrap::clampToEdge;
    EXPECT_EQ(levelsKey(sampledOtherwise, pictures, 1), key) << "the texels are the same";
}

} // namespace
} // namespace torrance
