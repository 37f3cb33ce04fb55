// Files and data beside and inside a document.
#include "gltf_builder.h"

#include "files/gltf_uri.h"

namespace torrance {
namespace {

std::string textOf(const std::vector<std::byte>& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The triangle as .gltf text whose buffer is found at `uri`.
std::string documentWith(const std::string& uri, std::size_t byteLength = 36)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["buffers"] = {{{"byteLength", byteLength}, {"uri", uri}}};
    return builder.json.dump();
}

std::vector<std::byte> triangleBytes()
{
    return GltfBuilder::triangle().binary;
}

TEST(GltfUri, DecodesPercentEscapes)
{
    EXPECT_EQ(percentDecoded("a%20b%2Fc%2f%41"), "a b/c/A");
    EXPECT_EQ(percentDecoded("100%"), "100%");
    EXPECT_EQ(percentDecoded("%zz%4"), "%zz%4");
    EXPECT_EQ(percentDecoded("%c3%a9"), "\xc3\xa9");
}

// RFC 4648, section 10: test vectors.
TEST(GltfUri, DecodesBase64)
{
    const auto decoded = [](const std::string& text) { return textOf(*dataOfUri("data:;base64," + text, "f", "i")); };
    EXPECT_EQ(decoded(""), "");
    EXPECT_EQ(decoded("Zg=="), "f");
    EXPECT_EQ(decoded("Zm8="), "fo");
    EXPECT_EQ(decoded("Zm9v"), "foo");
    EXPECT_EQ(decoded("Zm9vYg=="), "foob");
    EXPECT_EQ(decoded("Zm9vYmE="), "fooba");
    EXPECT_EQ(decoded("Zm9vYmFy"), "foobar");
    EXPECT_EQ(decoded("Zm9vYg"), "foob") << "padding may be left out";
    EXPECT_THROW(decoded("Zm9vY"), Error);
    EXPECT_THROW(decoded("Zm9*"), Error);
    EXPECT_EQ(textOf(*dataOfUri("DATA:text/plain,a%20b", "f", "i")), "a b");
    EXPECT_THROW(dataOfUri("data:text/plain;base64", "f", "i"), Error);
    EXPECT_FALSE(dataOfUri("data.bin", "f", "i").has_value());
}

TEST(GltfUri, LoadsDataInsideTheText)
{
    // The nine floats of the triangle, base64 by hand: 36 bytes, only 1.0f = 00 00 80 3f at bytes 12 and 28.
    const TestFolder folder;
    const auto path = folder.write(
        "model.gltf",
        documentWith("data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"));
    EXPECT_EQ(loadScene(path).scene.primitives.at(0).positions, (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_TRUE(contains(errorOf(folder.write("short.gltf", documentWith("data:;base64,AAAA"))),
                         "/buffers/0: claims 36 bytes where its source has 3"));
    EXPECT_TRUE(contains(errorOf(folder.write("bad.gltf", documentWith("data:;base64,????"))),
                         "base64 of its data URI is damaged"));
}

TEST(GltfUri, LoadsFilesBesideTheDocument)
{
    const TestFolder folder;
    folder.write("some data.bin", triangleBytes());
    folder.write("sub/deep.bin", triangleBytes());
    EXPECT_EQ(errorOf(folder.write("a.gltf", documentWith("some%20data.bin"))), "");
    EXPECT_EQ(errorOf(folder.write("b.gltf", documentWith("some data.bin"))), "");
    EXPECT_EQ(errorOf(folder.write("c.gltf", documentWith("sub/deep.bin"))), "");
    EXPECT_EQ(errorOf(folder.write("d.gltf", documentWith("./sub/./deep.bin"))), "");
}

TEST(GltfUri, AcceptsASourceLongerThanItsBufferAndNoneShorter)
{
    const TestFolder folder;
    std::vector<std::byte> longer = triangleBytes();
    longer.resize(100);
    folder.write("longer.bin", longer);
    EXPECT_EQ(errorOf(folder.write("a.gltf", documentWith("longer.bin"))), "");
    EXPECT_TRUE(contains(errorOf(folder.write("b.gltf", documentWith("longer.bin", 101))),
                         "/buffers/0: claims 101 bytes where its source has 100"));
}

TEST(GltfUri, RefusesFilesThatAreNotThere)
{
    const TestFolder folder;
    folder.write("sub/deep.bin", triangleBytes());
    EXPECT_TRUE(contains(errorOf(folder.write("a.gltf", documentWith("none.bin"))), "none.bin): no such file"));
    EXPECT_TRUE(contains(errorOf(folder.write("b.gltf", documentWith("sub"))), "is a folder"));
    EXPECT_TRUE(contains(errorOf(folder.write("c.gltf", documentWith(""))), "names no file"));
    EXPECT_TRUE(contains(errorOf(folder.write("d.gltf", documentWith("a%00b"))), "names no file"));
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["buffers"] = {{{"byteLength", 36}}};
    EXPECT_TRUE(contains(errorOf(folder.write("e.gltf", builder.json.dump())), "/buffers/0: has no data"));
}

TEST(GltfUri, StaysInTheFolderOfTheModelUnlessTold)
{
    const TestFolder folder;
    const auto outside = folder.write("outside.bin", triangleBytes());
    const std::string absolute = outside.string();
    const std::vector<std::string> leaving = {"../outside.bin",
                                              "sub/../../outside.bin",
                                              "%2e%2e/outside.bin",
                                              "%2E%2E%2Foutside.bin",
                                              "..\\outside.bin",
                                              "..%5coutside.bin",
                                              absolute,
                                              "file://" + absolute,
                                              "FILE://" + absolute,
                                              "%2f" + absolute};
    folder.write("model/sub/nothing", std::string("x"));
    for (const std::string& uri : leaving) {
        const auto path = folder.write("model/model.gltf", documentWith(uri));
        const std::string message = errorOf(path);
        EXPECT_TRUE(contains(message, "/buffers/0") && contains(message, "--allow-external")) << uri << ": " << message;
    }
    for (const std::string& uri : {leaving[0], leaving[1], leaving[2], leaving[6], leaving[7]})
        EXPECT_EQ(errorOf(folder.write("model/model.gltf", documentWith(uri)), {.allowExternal = true}), "") << uri;
}

TEST(GltfUri, NeverFetches)
{
    const TestFolder folder;
    for (const char* uri :
         {"http://localhost/a.bin", "https://example.org/a.bin", "ftp:a", "c:evil.bin", "c:\\evil.bin"}) {
        const auto path = folder.write("model.gltf", documentWith(uri));
        EXPECT_TRUE(contains(errorOf(path), "a URI with a scheme")) << uri;
        EXPECT_TRUE(contains(errorOf(path, {.allowExternal = true}), "a URI with a scheme")) << uri;
    }
}

TEST(GltfUri, OpensOnlyBuffersThatAViewUses)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["buffers"] = {{{"byteLength", 36}}, {{"byteLength", 5}, {"uri", "never-opened.bin"}}};
    const LoadedScene loaded = load(builder);
    EXPECT_EQ(loaded.facts.bufferBytes, 36u);
}

TEST(GltfUri, QuotesLongUrisShort)
{
    const TestFolder folder;
    const std::string message = errorOf(folder.write("model.gltf", documentWith("http:" + std::string(100000, 'x'))));
    EXPECT_LT(message.size(), 500u);
}

} // namespace
} // namespace torrance
