#include "prepare/kept_textures.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace torrance {
namespace {

PlannedTexture planned(int width, int height)
{
    PlannedTexture texture{.width = width, .height = height};
    texture.channels[0] = {0, 0};
    texture.channels[1] = {1, 2};
    return texture;
}

std::vector<std::byte> counted(std::size_t count, int first)
{
    std::vector<std::byte> bytes(count);
    for (std::byte& value : bytes)
        value = static_cast<std::byte>(first++);
    return bytes;
}

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

TEST_F(KeptTexturesTest, GiveBackLevels)
{
    KeptTextures kept(folder);
    for (const std::size_t count : {std::size_t(60), std::size_t(1) << 20}) {
        const ContentHash key = hashText(std::to_string(count));
        const std::vector<std::byte> made = counted(count, 1);
        kept.keepLevels(key, made);
        std::vector<std::byte> read(count);
        ASSERT_TRUE(kept.readLevels(key, read));
        EXPECT_EQ(read, made);
        EXPECT_FALSE(kept.readLevels(hashText("other"), read));
        EXPECT_FALSE(kept.readLevels(key, std::span(read).first(count - 1))) << "of another size";
        const auto mapped = kept.mapLevels(key);
        EXPECT_EQ(mapped.has_value(), count >= std::size_t(1) << 20) << "what fills pages";
        EXPECT_TRUE(!mapped || std::ranges::equal(mapped->bytes(), made));
    }
    EXPECT_FALSE(kept.mapLevels(hashText("other")));
}

TEST_F(KeptTexturesTest, TheKeyIsOfAllThatLevelsAreMadeFrom)
{
    const std::vector<ContentHash> pictures = {hashText("a"), hashText("b")};
    const PlannedTexture texture = planned(64, 32);
    const std::vector<std::size_t> layout = {8192, 0, 256};
    const auto key = levelsKey(texture, pictures, 1, layout);
    ASSERT_TRUE(key);
    EXPECT_EQ(levelsKey(texture, pictures, 1, layout), key);
    EXPECT_FALSE(levelsKey(texture, {}, 1, layout)) << "pictures that come from nowhere";
    EXPECT_NE(levelsKey(texture, pictures, 2, layout), key);
    EXPECT_NE(levelsKey(texture, pictures, 1, std::vector<std::size_t>{8192, 0, 512}), key);
    EXPECT_NE(levelsKey(texture, std::vector{hashText("a"), hashText("c")}, 1, layout), key);
    const auto differs = [&](auto&& change) {
        PlannedTexture other = texture;
        change(other);
        EXPECT_NE(levelsKey(other, pictures, 1, layout), key);
    };
    differs([](PlannedTexture& t) { t.content = TexelContent::normal; });
    differs([](PlannedTexture& t) { t.weighByAlpha = true; });
    differs([](PlannedTexture& t) { t.lengthInAlpha = true; });
    differs([](PlannedTexture& t) { t.sampler.mip = MipFilter::none; });
    differs([](PlannedTexture& t) { t.channels[1].channel = 1; });
    differs([](PlannedTexture& t) { std::swap(t.channels[0], t.channels[1]); });
    differs([](PlannedTexture& t) { t.words = WordChannels{{{0, 0}, {1, 2}}}; });
    differs([](PlannedTexture& t) { t.width = 32; });
    differs([](PlannedTexture& t) { t.height = 64; });
    PlannedTexture sampledOtherwise = texture;
    sampledOtherwise.sampler.wrapS = Wrap::clampToEdge;
    EXPECT_EQ(levelsKey(sampledOtherwise, pictures, 1, layout), key) << "the texels are the same";
}

} // namespace
} // namespace torrance
