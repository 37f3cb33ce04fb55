// Pictures that whoever loads a scene knows are not decoded; all others are, each in its place.
#include "gltf_builder.h"
#include "gltf_save_cases.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

/// A triangle under three pictures.
struct ThreePictures
{
    std::vector<std::byte> first = test::pngOf(10), second, third = test::pngOf(30);
    TestFolder folder;
    std::filesystem::path file;

    explicit ThreePictures(std::vector<std::byte> bytes) : second(std::move(bytes))
    {
        GltfBuilder builder = GltfBuilder::triangle();
        builder.primitive()["material"] = 0;
        for (const auto* picture : {&first, &second, &third})
            builder.append("images", {{"bufferView", builder.addView(*picture)}, {"mimeType", "image/png"}});
        builder.json["textures"] = {{{"source", 0}}, {{"source", 1}}, {{"source", 2}}};
        builder.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                      {"normalTexture", {{"index", 1}}},
                                      {"emissiveTexture", {{"index", 2}}}}};
        file = folder.write("model.glb", builder.glb());
    }
};

TEST(KnownImages, AreNotDecoded)
{
    const ThreePictures model(std::vector<std::byte>(16)); // no picture at all
    EXPECT_THROW(loadScene(model.file), Error) << "one cannot be decoded";
    LoadOptions options;
    options.known = [&](const ContentHash& encoded) {
        return encoded == hashBytes(model.second) ? std::optional(KnownImage{7, 5, TexelFormat::rgba16}) : std::nullopt;
    };
    const LoadedScene loaded = loadScene(model.file, options);
    ASSERT_EQ(loaded.scene.images.size(), 3u);
    EXPECT_EQ(loaded.encodedImages,
              (std::vector{hashBytes(model.first), hashBytes(model.second), hashBytes(model.third)}));
    EXPECT_EQ(loaded.scene.images[0].texels[0], std::byte{10});
    EXPECT_EQ(loaded.scene.images[2].texels[0], std::byte{30});
    const TextureImage& known = loaded.scene.images[1];
    EXPECT_TRUE(known.texels.empty());
    EXPECT_EQ((KnownImage{known.width, known.height, known.format}), (KnownImage{7, 5, TexelFormat::rgba16}));
    EXPECT_FALSE(known.name.empty());
    EXPECT_EQ(loaded.facts.texelBytes,
              loaded.scene.images[0].texels.size() + 7 * 5 * 8 + loaded.scene.images[2].texels.size());
}

TEST(KnownImages, WhoAsksForNoneHasNoHashes)
{
    const ThreePictures model(test::pngOf(20));
    const LoadedScene loaded = loadScene(model.file);
    EXPECT_EQ(loaded.scene.images.size(), 3u);
    EXPECT_TRUE(loaded.encodedImages.empty());
}

} // namespace
} // namespace torrance
