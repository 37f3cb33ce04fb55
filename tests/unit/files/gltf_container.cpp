// The file as a whole: form, lengths, JSON text, version.
#include "gltf_builder.h"

#include "files/json_read.h"

namespace torrance {
namespace {

std::string errorOfBytes(const std::vector<std::byte>& bytes)
{
    const TestFolder folder;
    return errorOf(folder.write("model.glb", bytes));
}

std::string errorOfText(const std::string& text)
{
    const TestFolder folder;
    return errorOf(folder.write("model.gltf", text));
}

void setWord(std::vector<std::byte>& bytes, std::size_t offset, std::uint32_t word)
{
    std::memcpy(bytes.data() + offset, &word, sizeof word);
}

TEST(GltfContainer, LoadsATriangle)
{
    const LoadedScene loaded = load(GltfBuilder::triangle());
    ASSERT_EQ(loaded.scene.primitives.size(), 1u);
    EXPECT_EQ(loaded.scene.primitives[0].indices, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(loaded.facts.triangles, 1u);
    EXPECT_EQ(loaded.facts.container, "GLB");
    EXPECT_TRUE(loaded.warnings.empty());
    EXPECT_EQ(loaded.scene.name, "model");
}

TEST(GltfContainer, RefusesWhatIsNoFile)
{
    const TestFolder folder;
    EXPECT_TRUE(contains(errorOf(folder.path / "none.glb"), "no such file"));
    EXPECT_TRUE(contains(errorOf(folder.path), "is a folder"));
    EXPECT_TRUE(contains(errorOf(folder.write("empty.glb", std::string())), "is empty"));
    EXPECT_TRUE(contains(errorOf(folder.write("noise.glb", "\x01\x02\x03\x04 not a model")), "neither a GLB nor glTF"));
    EXPECT_TRUE(contains(errorOf("/dev/zero"), "not a regular file"));
}

TEST(GltfContainer, RefusesEveryTruncation)
{
    const std::vector<std::byte> whole = GltfBuilder::triangle().glb();
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_NE(errorOfBytes({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}), "") << length;
}

TEST(GltfContainer, RefusesWrongHeaders)
{
    const std::vector<std::byte> whole = GltfBuilder::triangle().glb();
    const auto changed = [&](std::size_t offset, std::uint32_t word) {
        std::vector<std::byte> bytes = whole;
        setWord(bytes, offset, word);
        return errorOfBytes(bytes);
    };
    EXPECT_TRUE(contains(changed(4, 1), "version 1"));
    EXPECT_TRUE(contains(changed(4, 3), "version 3"));
    EXPECT_TRUE(contains(changed(8, 0xffffffffu), "GLB header: claims 4294967295 bytes"));
    EXPECT_TRUE(contains(changed(8, 4), "GLB header"));
    EXPECT_TRUE(contains(changed(12, 0xfffffff0u), "GLB chunk 0: claims"));
    EXPECT_TRUE(contains(changed(16, 0x004E4942), "not of type JSON"));
    EXPECT_TRUE(contains(changed(0, 0x12345678), "neither a GLB"));
}

TEST(GltfContainer, IgnoresBytesAfterTheStatedLengthAndChunksOfExtensions)
{
    std::vector<std::byte> bytes = GltfBuilder::triangle().glb();
    bytes.resize(bytes.size() + 100, std::byte{0x5a});
    EXPECT_EQ(loadBytes(bytes).facts.triangles, 1u);

    bytes = GltfBuilder::triangle().glb();
    const std::size_t end = bytes.size();
    bytes.resize(end + 12);
    setWord(bytes, end, 4);
    setWord(bytes, end + 4, 0x31313131);
    setWord(bytes, 8, static_cast<std::uint32_t>(bytes.size()));
    EXPECT_EQ(loadBytes(bytes).facts.triangles, 1u);
}

TEST(GltfContainer, SaysWhereJsonIsMalformed)
{
    EXPECT_TRUE(contains(errorOfText(R"({"asset": {"version": "2.0"}, "nodes": [{}, {"mesh" 1}]})"), "/nodes/1"));
    EXPECT_TRUE(contains(errorOfText(R"({"asset": {"version": "2.0"}, "nodes": [}))"), "malformed"));
    EXPECT_TRUE(contains(errorOfText("{\"asset\": {\"version\": \"2.0\", \"generator\": \"\xff\xfe\"}}"), "malformed"));
    EXPECT_TRUE(
        contains(errorOfText(R"({"asset": {"version": "2.0"}, "scene": 0, "scene": 1})"), "/scene: is given twice"));
    EXPECT_TRUE(contains(errorOfText(R"({"asset": {"version": "2.0"}} trailing)"), "malformed"));
}

TEST(GltfContainer, NamesTheNumberThatOverflows)
{
    const std::string message =
        errorOfText(R"({"asset": {"version": "2.0"}, "nodes": [{}, {"translation": [0, 1e999, 0]}]})");
    EXPECT_TRUE(contains(message, "/nodes/1/translation/1: number 1e999 overflows")) << message;
    EXPECT_TRUE(
        contains(errorOfText(R"({"asset": {"version": "2.0"}, "nodes": [{"scale": [NaN, 1, 1]}]})"), "/nodes/0"));
}

TEST(GltfContainer, LimitsNesting)
{
    const auto nested = [](int depth) {
        const auto n = static_cast<std::size_t>(depth);
        return R"({"asset": {"version": "2.0"}, "extras": )" + std::string(n, '[') + std::string(n, ']') + "}";
    };
    EXPECT_EQ(errorOfText(nested(kMaxJsonDepth - 1)), "") << "extras this deep are read and dropped";
    EXPECT_TRUE(contains(errorOfText(nested(kMaxJsonDepth)), "nested more than"));
    EXPECT_TRUE(contains(errorOfText(nested(1000000)), "nested more than"));
}

TEST(GltfContainer, LimitsTheNumberOfValues)
{
    // The array itself is a value: with three numbers it makes four.
    EXPECT_EQ(readJson("[1, 2, 3]", "a.gltf", 4).size(), 3u);
    EXPECT_THROW(readJson("[1, 2, 3]", "a.gltf", 3), Error);
}

TEST(GltfContainer, ReadsVersionTwoOnly)
{
    EXPECT_TRUE(contains(errorOfText(R"({"scenes": []})"), "/asset: is missing"));
    EXPECT_TRUE(contains(errorOfText("{}"), "/asset"));
    EXPECT_TRUE(contains(errorOfText(R"({"asset": {"version": "1.0"}})"), "needs glTF 1.0"));
    EXPECT_TRUE(contains(errorOfText(R"({"asset": {"version": "3.0"}})"), "needs glTF 3.0"));
    EXPECT_TRUE(contains(errorOfText(R"({"asset": {"version": "2.1", "minVersion": "2.1"}})"), "needs glTF 2.1"));
    EXPECT_EQ(errorOfText(R"({"asset": {"version": "2.1", "minVersion": "2.0"}})"), "");
    EXPECT_EQ(errorOfText(R"({"asset": {"version": "2.7"}})"), "") << "a later 2.x reads as 2.0";
    EXPECT_TRUE(contains(errorOfText(R"({"asset": {"version": 2.0}})"), "/asset/version"));
    EXPECT_TRUE(contains(errorOfText(R"({"asset": {"version": "two"}})"), "/asset/version"));
}

TEST(GltfContainer, AcceptsAByteOrderMark)
{
    EXPECT_EQ(errorOfText("\xef\xbb\xbf{\"asset\": {\"version\": \"2.0\"}}"), "");
}

} // namespace
} // namespace torrance
