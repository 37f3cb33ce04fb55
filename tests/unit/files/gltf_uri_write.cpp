// URIs that are written, held against the reader of URIs and against their standards.
#include "files/gltf_uri_write.h"

#include "gltf_builder.h"

#include "files/gltf_uri.h"

namespace torrance {
namespace {

namespace fs = std::filesystem;

TEST(GltfUriWrite, EscapesAllThatCouldMeanSomething)
{
    EXPECT_EQ(percentEncoded("a b/c-d_e.f~g"), "a%20b/c-d_e.f~g");
    EXPECT_EQ(percentEncoded("x:y?z#%41"), "x%3Ay%3Fz%23%2541");
    std::string every;
    for (int code = 1; code < 256; ++code)
        every += static_cast<char>(code);
    EXPECT_EQ(percentDecoded(percentEncoded(every)), every);
    EXPECT_TRUE(isRelativeUri(percentEncoded("c:/a.png"))) << "no scheme";
}

TEST(GltfUriWrite, LeadsFromTheFolderToTheFile)
{
    const TestFolder folder;
    const fs::path model = folder.path / "models/one";
    fs::create_directories(model);
    EXPECT_EQ(relativeUri(model / "a b.png", model), "a%20b.png");
    EXPECT_EQ(relativeUri(folder.path / "textures/x.png", model), "../../textures/x.png");
    EXPECT_EQ(relativeUri(model / "../two/x.png", model), "../two/x.png");
    fs::create_directories(folder.path / "deep/er/still");
    fs::create_directory_symlink(folder.path / "deep/er/still", folder.path / "link");
    EXPECT_EQ(relativeUri(folder.path / "x.png", folder.path / "link"), "../../../x.png") << "as the system walks ..";
    folder.write("deep/real.png", std::string("x"));
    fs::create_symlink(folder.path / "deep/real.png", model / "linked.png");
    EXPECT_EQ(relativeUri(model / "linked.png", model), "linked.png") << "a file's own link is its name";
}

TEST(GltfUriWrite, KnowsWhatLeavesTheFolder)
{
    for (const char* uri : {"..", "../a", "/a"})
        EXPECT_TRUE(leavesTheFolder(uri)) << uri;
    for (const char* uri : {"a", "..a", "a/b"})
        EXPECT_FALSE(leavesTheFolder(uri)) << uri;
}

// RFC 4648, section 10.
TEST(GltfUriWrite, WritesBase64)
{
    const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                           {"f", "Zg=="},
                                                           {"fo", "Zm8="},
                                                           {"foo", "Zm9v"},
                                                           {"foob", "Zm9vYg=="},
                                                           {"fooba", "Zm9vYmE="},
                                                           {"foobar", "Zm9vYmFy"}};
    for (const auto& [text, expected] : vectors)
        EXPECT_EQ(dataUri(std::as_bytes(std::span(std::string_view(text))), "x/y"),
                  "data:x/y;base64," + std::string(expected));
    std::vector<std::byte> every;
    for (int code = 0; code < 256; ++code)
        every.push_back(static_cast<std::byte>(code));
    EXPECT_EQ(dataOfUri(dataUri(every, "image/png"), "file", "item"), every);
}

} // namespace
} // namespace torrance
