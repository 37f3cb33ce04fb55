// What one file may ask for, with limits small enough to be met.
#include "gltf_builder.h"
#include "png_bytes.h"

namespace torrance {
namespace {

// A triangle without normals: three vertices as the file has them, and three that are not shared any more.
TEST(GltfLimits, CountVerticesOfAllPrimitives)
{
    GltfBuilder builder = GltfBuilder::triangle();
    EXPECT_EQ(errorOf(builder, {.limits = {.vertices = 6}}), "");
    EXPECT_TRUE(contains(errorOf(builder, {.limits = {.vertices = 5}}),
                         "/meshes/0/primitives/0: brings the file to more than 5 vertices"));
    builder.json["meshes"][0]["primitives"].push_back(builder.primitive());
    EXPECT_EQ(errorOf(builder, {.limits = {.vertices = 12}}), "");
    EXPECT_TRUE(contains(errorOf(builder, {.limits = {.vertices = 11}}), "/meshes/0/primitives/1: brings the file"));
}

TEST(GltfLimits, CountIndicesAfterUnrolling)
{
    GltfBuilder builder = GltfBuilder::triangle();
    // A strip of five indices: three triangles.
    builder.primitive()["indices"] =
        builder.addAccessor(std::vector<std::uint8_t>{0, 1, 2, 0, 1}, gltf::kUnsignedByte, "SCALAR", 5);
    builder.primitive()["mode"] = 5;
    EXPECT_EQ(errorOf(builder, {.limits = {.indices = 9}}), "");
    EXPECT_TRUE(contains(errorOf(builder, {.limits = {.indices = 8}}), "more than 8 indices"));
}

TEST(GltfLimits, CountInstances)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}}};
    builder.json["scenes"] = {{{"nodes", {0, 1}}}};
    EXPECT_EQ(errorOf(builder, {.limits = {.instances = 2}}), "");
    EXPECT_TRUE(
        contains(errorOf(builder, {.limits = {.instances = 1}}), "/nodes/1: brings the file to more than 1 instances"));

    builder = GltfBuilder::triangle();
    const int translation =
        builder.append("accessors", {{"componentType", gltf::kFloat}, {"count", 1000}, {"type", "VEC3"}});
    builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = translation;
    EXPECT_EQ(errorOf(builder, {.limits = {.instances = 1000}}), "");
    EXPECT_TRUE(contains(errorOf(builder, {.limits = {.instances = 999}}), "/nodes/0: asks for 1000 instances"));
}

TEST(GltfLimits, CountTexelsBeforeDecoding)
{
    test::PngSpec spec;
    spec.width = 100;
    spec.height = 50; // a header alone: were it decoded, the missing scanlines would be the error
    const std::string png = test::pngBytes(spec);
    GltfBuilder builder = GltfBuilder::triangle();
    builder.primitive()["material"] = 0;
    builder.json["images"] = {{{"bufferView", builder.addView(std::vector<char>(png.begin(), png.end()))}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
    EXPECT_TRUE(
        contains(errorOf(builder, {.limits = {.texelBytes = 39999}}), "/images/0: brings the images")); // 100*50*8
    EXPECT_FALSE(contains(errorOf(builder, {.limits = {.texelBytes = 40000}}), "brings the images"));
}

} // namespace
} // namespace torrance
