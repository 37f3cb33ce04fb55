// Which items of the document the scene's items are.
#include "gltf_builder.h"
#include "png_bytes.h"

namespace torrance {
namespace {

TEST(GltfItems, AreNumbersOfTheDocumentWhateverIsLeftOut)
{
    GltfBuilder builder = GltfBuilder::triangle();
    const nlohmann::json drawn = builder.primitive();
    const int uv = builder.addFloats({0, 0, 1, 0, 0, 1}, "VEC2");
    nlohmann::json textured = drawn;
    textured["attributes"]["TEXCOORD_3"] = uv;
    textured["material"] = 2;
    test::PngSpec spec;
    spec.scanlines = {0, 255, 0, 0, 255};
    const std::string png = test::pngBytes(spec);
    const int view = builder.addView(std::vector<char>(png.begin(), png.end()));
    builder.json["images"] = {{{"uri", "not-drawn.png"}}, {{"bufferView", view}, {"mimeType", "image/png"}}};
    builder.json["textures"] = {{{"source", 0}}, {{"source", 1}}, {{"source", 1}}};
    builder.json["materials"] = {
        {{"name", "not drawn"}}, {{"name", "plain"}}, {{"emissiveTexture", {{"index", 2}, {"texCoord", 3}}}}};
    const nlohmann::json empty = {{"attributes", nlohmann::json::object()}};
    nlohmann::json plain = drawn;
    plain["material"] = 1;
    builder.json["meshes"] = {{{"primitives", {plain}}}, {{"primitives", {empty, textured, plain}}}};
    builder.json["nodes"] = {{{"mesh", 1}}};

    const LoadedScene loaded = load(builder);
    using Item = FileItems::MeshPrimitive;
    EXPECT_EQ(loaded.items.primitives, (std::vector<Item>{{1, 1}, {1, 2}})) << "mesh 1, without its empty primitive";
    EXPECT_EQ(loaded.items.materials, (std::vector<int>{1, 2}));
    ASSERT_EQ(loaded.items.uvSets.size(), 2u);
    EXPECT_EQ(loaded.items.uvSets[1][0], 3) << "the only set that is used";
    EXPECT_EQ(loaded.items.textures, std::vector<int>{2});
    EXPECT_EQ(loaded.items.images, std::vector<int>{1});
}

} // namespace
} // namespace torrance
