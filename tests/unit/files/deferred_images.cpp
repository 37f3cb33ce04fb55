// Images that are decoded after a scene was loaded, against the same scene with all of them decoded.
#include "files/deferred_images.h"

#include "core/parallel.h"
#include "files/image_encoders.h"
#include "files/texture_file.h"
#include "gltf_builder.h"
#include "png_bytes.h"

namespace torrance {
namespace {

std::string png(std::uint32_t width, std::uint32_t height, int bitDepth)
{
    test::PngSpec spec = {.width = width, .height = height, .bitDepth = bitDepth, .colorType = 2, .scanlines = {}};
    for (std::uint32_t y = 0; y < height; ++y) {
        spec.scanlines.push_back(static_cast<std::uint8_t>(y % 5));
        for (std::uint32_t i = 0; i < 3 * width * static_cast<std::uint32_t>(bitDepth) / 8; ++i)
            spec.scanlines.push_back(static_cast<std::uint8_t>(7 * i + 31 * y));
    }
    return test::pngBytes(spec);
}

std::string jpeg()
{
    const Image grey(9, 4, 3, 0.5f);
    const std::vector<std::byte> bytes = encodeJpeg(quantizedRows(grey, 8), 90);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string dataUri(const std::string& bytes)
{
    static const char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text = "data:image/png;base64,";
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text.push_back(i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63]);
    }
    return text;
}

/// A triangle whose material uses every image there is.
struct TexturedModel
{
    GltfBuilder builder = GltfBuilder::triangle();
    const TestFolder folder;

    void addView(const std::string& bytes)
    {
        add({{"bufferView", builder.addView(std::vector<char>(bytes.begin(), bytes.end()))}});
    }
    void add(const nlohmann::json& image)
    {
        const int number = builder.append("images", image);
        builder.append("textures", {{"source", number}});
        constexpr const char* kSlots[] = {"normalTexture", "occlusionTexture", "emissiveTexture"};
        builder.json["materials"][0][kSlots[number]] = {{"index", number}};
        builder.primitive()["material"] = 0;
    }
    LoadedScene load(bool defer) { return loadScene(write(), {.deferImages = defer}); }
    std::string error(bool defer) { return errorOf(write(), {.deferImages = defer}); }
    std::filesystem::path write() { return folder.write("model.glb", builder.glb()); }
};

/// Images from the file itself, from its text and from beside it; 8 and 16 bits and JPEG.
void addThreeImages(TexturedModel& model)
{
    model.addView(png(5, 40, 8));
    model.add({{"uri", dataUri(png(3, 2, 16))}});
    model.folder.write("beside.jpg", jpeg());
    model.add({{"uri", "beside.jpg"}});
}

TEST(DeferredImages, HaveTheirHeadersAtOnceAndTheirTexelsWhenAskedFor)
{
    TexturedModel model;
    addThreeImages(model);
    const LoadedScene eager = model.load(false);
    EXPECT_FALSE(eager.deferred);
    const LoadedScene loaded = model.load(true);
    std::filesystem::remove(model.folder.path / "beside.jpg"); // everything has been read
    ASSERT_TRUE(loaded.deferred);
    ASSERT_EQ(loaded.deferred->count(), 3u);
    EXPECT_EQ(loaded.facts.texelBytes, eager.facts.texelBytes);
    EXPECT_EQ(loaded.warnings, eager.warnings);
    for (const std::size_t i : {2u, 0u, 1u}) { // in no order
        const TextureImage &whole = eager.scene.images[i], &header = loaded.scene.images[i];
        EXPECT_TRUE(header.texels.empty());
        EXPECT_EQ(header.name, whole.name);
        EXPECT_EQ(header.width, whole.width);
        EXPECT_EQ(header.height, whole.height);
        EXPECT_EQ(header.format, whole.format);
        const TextureImage decoded = loaded.deferred->decode(i);
        EXPECT_EQ(decoded.name, whole.name);
        EXPECT_EQ(decoded.width, whole.width);
        EXPECT_TRUE(decoded.texels == whole.texels) << "image " << i;
    }
}

TEST(DeferredImages, DecodeOnSeveralThreadsInMemoryOfOthers)
{
    TexturedModel model;
    addThreeImages(model);
    const LoadedScene eager = model.load(false);
    for (int round = 0; round < 20; ++round) {
        const LoadedScene loaded = model.load(true);
        const std::vector<std::size_t> order = loaded.deferred->longestFirst();
        parallelFor(order.size(), 1, [&](std::size_t place) {
            TextureImage image = loaded.deferred->decode(order[place]);
            EXPECT_TRUE(image.texels == eager.scene.images[order[place]].texels);
            loaded.deferred->recycle(std::move(image));
        });
    }
}

TEST(DeferredImages, AreOrderedByTheBytesToDecode)
{
    TexturedModel model;
    for (const std::uint32_t height : {3u, 40u, 20u})
        model.addView(png(5, height, 8));
    EXPECT_EQ(model.load(true).deferred->longestFirst(), (std::vector<std::size_t>{1, 2, 0}));
}

TEST(DeferredImages, AreNoneWhereTheFileHasNone)
{
    TexturedModel model;
    EXPECT_FALSE(model.load(true).deferred);
}

// What a header tells is refused while loading, with the words of decoding.
TEST(DeferredImages, OfBadHeadersAreRefusedAtOnce)
{
    const std::string whole = png(5, 4, 8);
    std::string badHeader = whole;
    badHeader[20] ^= 1; // under the CRC of IHDR
    const test::PngSpec huge = {.width = 16385, .height = 1, .scanlines = {0}};
    const test::PngSpec manyTexels = {.width = 16384, .height = 16384, .scanlines = {0}};
    for (const std::string& bytes : {badHeader, test::pngBytes(huge), test::pngBytes(manyTexels), whole.substr(0, 30),
                                     std::string("GIF89a.."), jpeg().substr(0, 10), std::string("RIFF....WEBPVP8 ")})
    {
        TexturedModel model;
        model.addView(bytes);
        const std::string now = model.error(true);
        EXPECT_NE(now, "") << bytes.size() << " bytes";
        EXPECT_EQ(now, model.error(false));
    }
}

TEST(DeferredImages, CountTexelsBeforeAnythingIsDecoded)
{
    TexturedModel model;
    model.addView(png(5, 40, 8));
    const auto error = [&](std::uint64_t most) {
        return errorOf(model.write(), {.limits = {.texelBytes = most}, .deferImages = true});
    };
    EXPECT_EQ(error(5 * 40 * 8), "");
    EXPECT_NE(error(5 * 40 * 8 - 1).find("brings the images"), std::string::npos);
}

TEST(DeferredImages, OfBadTexelsAreRefusedWhenAskedFor)
{
    const std::string whole = png(5, 4, 8);
    TexturedModel model;
    model.addView(whole.substr(0, whole.size() - 20));
    const LoadedScene loaded = model.load(true);
    std::string message;
    try {
        loaded.deferred->decode(0);
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::input);
        message = error.what();
    }
    EXPECT_NE(message, "");
    EXPECT_EQ(message, model.error(false));
}

} // namespace
} // namespace torrance
