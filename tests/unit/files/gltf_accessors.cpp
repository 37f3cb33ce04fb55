// Accessors: every component type, layout and replacement, and everything that cannot be one.
#include "gltf_builder.h"

#include "files/gltf_accessors.h"

#include <limits>

namespace torrance {
namespace {

/// A triangle whose texture coordinates are the accessor under test.
GltfBuilder withUvs(int componentType, bool normalized, const auto& values)
{
    GltfBuilder builder = GltfBuilder::triangle();
    const int uv = builder.addAccessor(values, componentType, "VEC2", 3);
    if (normalized)
        builder.accessor(uv)["normalized"] = true;
    builder.primitive()["attributes"]["TEXCOORD_0"] = uv;
    builder.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    return builder;
}

std::vector<vec2> uvsOf(const GltfBuilder& builder)
{
    return load(builder).scene.primitives.at(0).uvs[0];
}

TEST(GltfAccessors, ReadIntegersAsTheyStand)
{
    const std::vector<vec2> expected = {{0, 1}, {100, 101}, {127, 2}};
    EXPECT_EQ(uvsOf(withUvs(gltf::kUnsignedByte, false, std::vector<std::uint8_t>{0, 1, 100, 101, 127, 2})), expected);
    EXPECT_EQ(uvsOf(withUvs(gltf::kByte, false, std::vector<std::int8_t>{0, 1, 100, 101, 127, 2})), expected);
    EXPECT_EQ(uvsOf(withUvs(gltf::kUnsignedShort, false, std::vector<std::uint16_t>{0, 1, 100, 101, 127, 2})),
              expected);
    EXPECT_EQ(uvsOf(withUvs(gltf::kShort, false, std::vector<std::int16_t>{0, 1, 100, 101, 127, 2})), expected);
    EXPECT_EQ(uvsOf(withUvs(gltf::kShort, false, std::vector<std::int16_t>{-32768, 32767, 0, 0, 0, 0}))[0],
              vec2(-32768, 32767));
}

// glTF 2.0, 3.11: c / 255, c / 65535, max(c / 127, -1), max(c / 32767, -1).
TEST(GltfAccessors, NormaliseIntegers)
{
    const auto u8 = uvsOf(withUvs(gltf::kUnsignedByte, true, std::vector<std::uint8_t>{0, 255, 51, 102, 1, 254}));
    EXPECT_EQ(u8, (std::vector<vec2>{{0, 1}, {0.2f, 0.4f}, {1.0f / 255.0f, 254.0f / 255.0f}}));
    const auto u16 = uvsOf(withUvs(gltf::kUnsignedShort, true, std::vector<std::uint16_t>{0, 65535, 13107, 1, 0, 0}));
    EXPECT_EQ(u16[0], vec2(0, 1));
    EXPECT_EQ(u16[1], vec2(0.2f, 1.0f / 65535.0f));
    const auto i8 = uvsOf(withUvs(gltf::kByte, true, std::vector<std::int8_t>{-128, 127, -127, 0, 1, -1}));
    EXPECT_EQ(i8, (std::vector<vec2>{{-1, 1}, {-1, 0}, {1.0f / 127.0f, -1.0f / 127.0f}}));
    const auto i16 = uvsOf(withUvs(gltf::kShort, true, std::vector<std::int16_t>{-32768, 32767, -32767, 0, 1, -1}));
    EXPECT_EQ(i16, (std::vector<vec2>{{-1, 1}, {-1, 0}, {1.0f / 32767.0f, -1.0f / 32767.0f}}));
}

TEST(GltfAccessors, FollowStridesAndOffsets)
{
    GltfBuilder builder = GltfBuilder::triangle();
    // Position and texture coordinates of each vertex side by side, 20 bytes, behind 8 bytes that are nobody's.
    const int view = builder.addView(std::vector<float>{9, 9, 0, 0, 0, .1f, .2f, 1, 0, 0, .3f, .4f, 0, 1, 0, .5f, .6f});
    builder.view(view)["byteStride"] = 20;
    const auto add = [&](std::size_t offset, const char* type) {
        return builder.append("accessors", {{"bufferView", view},
                                            {"byteOffset", 8 + offset},
                                            {"componentType", gltf::kFloat},
                                            {"count", 3},
                                            {"type", type}});
    };
    builder.primitive()["attributes"] = {{"POSITION", add(0, "VEC3")}, {"TEXCOORD_0", add(12, "VEC2")}};
    const Primitive primitive = load(builder).scene.primitives.at(0);
    EXPECT_EQ(primitive.positions, (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(primitive.uvs[0], (std::vector<vec2>{{.1f, .2f}, {.3f, .4f}, {.5f, .6f}}));
}

TEST(GltfAccessors, ReplaceSparseElements)
{
    for (const int indexType : {gltf::kUnsignedByte, gltf::kUnsignedShort, gltf::kUnsignedInt}) {
        GltfBuilder builder = GltfBuilder::triangle();
        const int values = builder.addView(std::vector<float>{7, 8, 9, 4, 5, 6});
        const int indices = indexType == gltf::kUnsignedByte    ? builder.addView(std::vector<std::uint8_t>{0, 2})
                            : indexType == gltf::kUnsignedShort ? builder.addView(std::vector<std::uint16_t>{0, 2})
                                                                : builder.addView(std::vector<std::uint32_t>{0, 2});
        builder.accessor(0)["sparse"] = {{"count", 2},
                                         {"indices", {{"bufferView", indices}, {"componentType", indexType}}},
                                         {"values", {{"bufferView", values}}}};
        EXPECT_EQ(load(builder).scene.primitives.at(0).positions, (std::vector<vec3>{{7, 8, 9}, {1, 0, 0}, {4, 5, 6}}));

        builder.accessor(0).erase("bufferView");
        EXPECT_EQ(load(builder).scene.primitives.at(0).positions, (std::vector<vec3>{{7, 8, 9}, {0, 0, 0}, {4, 5, 6}}))
            << "without a buffer view the rest is zero";
    }
}

TEST(GltfAccessors, ReadIndicesOfEveryTypeAlsoSparseOnesWithoutAView)
{
    GltfBuilder builder = GltfBuilder::triangle();
    const std::vector<std::uint32_t> expected = {2, 1, 0};
    builder.primitive()["indices"] =
        builder.addAccessor(std::vector<std::uint8_t>{2, 1, 0}, gltf::kUnsignedByte, "SCALAR", 3);
    EXPECT_EQ(load(builder).facts.triangles, 1u);
    builder.primitive()["attributes"]["NORMAL"] = builder.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    EXPECT_EQ(load(builder).scene.primitives.at(0).indices, expected);
    builder.primitive()["indices"] =
        builder.addAccessor(std::vector<std::uint16_t>{2, 1, 0}, gltf::kUnsignedShort, "SCALAR", 3);
    EXPECT_EQ(load(builder).scene.primitives.at(0).indices, expected);
    builder.primitive()["indices"] =
        builder.addAccessor(std::vector<std::uint32_t>{2, 1, 0}, gltf::kUnsignedInt, "SCALAR", 3);
    EXPECT_EQ(load(builder).scene.primitives.at(0).indices, expected);

    const int places = builder.addView(std::vector<std::uint8_t>{0, 1});
    const int values = builder.addView(std::vector<std::uint16_t>{2, 1});
    builder.primitive()["indices"] =
        builder.append("accessors", {{"componentType", gltf::kUnsignedShort},
                                     {"count", 3},
                                     {"type", "SCALAR"},
                                     {"sparse",
                                      {{"count", 2},
                                       {"indices", {{"bufferView", places}, {"componentType", gltf::kUnsignedByte}}},
                                       {"values", {{"bufferView", values}}}}}});
    EXPECT_EQ(load(builder).scene.primitives.at(0).indices, expected);
}

TEST(GltfAccessors, AcceptWholeNumbersWithAFraction)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.accessor(0)["count"] = 3.0;
    builder.accessor(0)["componentType"] = 5126.0;
    builder.primitive()["mode"] = 4.0;
    EXPECT_EQ(load(builder).facts.triangles, 1u);
    builder.accessor(0)["count"] = 2.5;
    EXPECT_TRUE(contains(errorOf(builder), "/accessors/0/count: is not a whole number"));
}

TEST(GltfAccessors, RefuseRangesOutsideTheirViewOrBuffer)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.accessor(0)["count"] = 4;
    EXPECT_TRUE(contains(errorOf(builder), "/accessors/0: reads up to byte 48 of a buffer view of 36"));
    builder.accessor(0)["count"] = 4000000000000;
    EXPECT_TRUE(contains(errorOf(builder), "/accessors/0: reads up to byte"));
    builder.accessor(0)["count"] = 9007199254740991;
    EXPECT_TRUE(contains(errorOf(builder), "/accessors/0: reads up to byte")) << "no overflow";
    builder.accessor(0)["count"] = 1e300;
    EXPECT_TRUE(contains(errorOf(builder), "/accessors/0/count"));
    builder.accessor(0)["count"] = -1;
    EXPECT_TRUE(contains(errorOf(builder), "/accessors/0/count"));
    builder.accessor(0)["count"] = 0;
    EXPECT_TRUE(contains(errorOf(builder), "/accessors/0: has a count of 0"));

    builder = GltfBuilder::triangle();
    builder.accessor(0)["byteOffset"] = 4;
    EXPECT_TRUE(contains(errorOf(builder), "/accessors/0: reads up to byte 40"));
    builder = GltfBuilder::triangle();
    builder.view(0)["byteLength"] = 37;
    EXPECT_TRUE(contains(errorOf(builder), "/bufferViews/0: ends at byte 37 of a buffer of 36"));
    builder.view(0)["byteLength"] = 36;
    builder.view(0)["byteOffset"] = 9007199254740990;
    EXPECT_TRUE(contains(errorOf(builder), "/bufferViews/0: ends at byte"));
    builder = GltfBuilder::triangle();
    builder.json["buffers"] = {{{"byteLength", 400}}};
    EXPECT_TRUE(contains(errorOf(builder), "/buffers/0: claims 400 bytes where its source has 36"));
}

TEST(GltfAccessors, RefuseMisalignedAndOverlappingElements)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.accessor(0)["byteOffset"] = 2;
    EXPECT_TRUE(contains(errorOf(builder), "/accessors/0: is misaligned"));
    builder = GltfBuilder::triangle();
    builder.binary.resize(40);
    builder.view(0)["byteOffset"] = 2;
    EXPECT_TRUE(contains(errorOf(builder), "/accessors/0: is misaligned")) << "the view's offset counts too";
    builder = GltfBuilder::triangle();
    builder.view(0)["byteStride"] = 14;
    EXPECT_TRUE(contains(errorOf(builder), "/accessors/0: is misaligned"));
    builder.view(0)["byteStride"] = 8;
    EXPECT_TRUE(contains(errorOf(builder), "/accessors/0: has elements of 12 bytes that overlap, being 8 apart"));
    builder.view(0)["byteStride"] = 256;
    EXPECT_TRUE(contains(errorOf(builder), "/bufferViews/0: has a stride of 256"));
}

TEST(GltfAccessors, RefuseUnknownTypes)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.accessor(0)["componentType"] = 5124;
    EXPECT_TRUE(contains(errorOf(builder), "unknown componentType 5124"));
    builder = GltfBuilder::triangle();
    builder.accessor(0)["type"] = "VEC5";
    EXPECT_TRUE(contains(errorOf(builder), "unknown type \"VEC5\""));
    builder = GltfBuilder::triangle();
    builder.accessor(0)["normalized"] = true;
    EXPECT_TRUE(contains(errorOf(builder), "does not normalize"));
    builder = GltfBuilder::triangle();
    builder.accessor(0)["type"] = "VEC2";
    EXPECT_TRUE(contains(errorOf(builder), "/POSITION: has a format that glTF does not allow"));
}

TEST(GltfAccessors, RefuseSparseElementsThatOverlapOrLeave)
{
    const auto broken = [](const std::vector<std::uint8_t>& places, std::size_t count) {
        GltfBuilder builder = GltfBuilder::triangle();
        const int values = builder.addView(std::vector<float>(24, 1.0f));
        const int indices = builder.addView(places);
        builder.accessor(0)["sparse"] = {{"count", count},
                                         {"indices", {{"bufferView", indices}, {"componentType", gltf::kUnsignedByte}}},
                                         {"values", {{"bufferView", values}}}};
        return errorOf(builder);
    };
    EXPECT_EQ(broken({0, 1}, 2), "");
    EXPECT_TRUE(contains(broken({1, 1}, 2), "/accessors/0/sparse/indices: do not increase")) << "written twice";
    EXPECT_TRUE(contains(broken({1, 0}, 2), "do not increase"));
    EXPECT_TRUE(contains(broken({0, 3}, 2), "or pass the accessor's end, at 1"));
    EXPECT_TRUE(contains(broken({0, 1}, 3), "/accessors/0/sparse/indices: reads up to byte 3"));
    EXPECT_TRUE(contains(broken({0, 1, 2, 3}, 4), "replaces 4 of 3 elements"));
    EXPECT_TRUE(contains(broken({0, 1}, 0), "replaces 0 of 3 elements"));
}

TEST(GltfAccessors, LimitElementsThatNoDataBacks)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.accessor(0).erase("bufferView");
    builder.accessor(0)["count"] = kMaxElementsWithoutData + 1;
    EXPECT_TRUE(contains(errorOf(builder), "elements and no data"));
    builder.accessor(0)["count"] = 3;
    EXPECT_EQ(load(builder).scene.primitives.at(0).positions, std::vector<vec3>(3, vec3(0.0f)));
}

TEST(GltfAccessors, ReplaceWhatIsNotFinite)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    GltfBuilder builder = GltfBuilder::triangle();
    builder.primitive()["attributes"]["POSITION"] =
        builder.addFloats({nan, 0, 0, 1, infinite, 0, 0, 1, -infinite}, "VEC3");
    const LoadedScene loaded = load(builder);
    EXPECT_EQ(loaded.scene.primitives.at(0).positions, (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(loaded.facts.replacedNumbers, 3u);
    EXPECT_EQ(warningsAbout(loaded, "3 numbers that are NaN or infinite"), 1);
}

} // namespace
} // namespace torrance
