// Loading that is not wanted any more ends before the next picture: it never comes to those that are missing or
// damaged.
#include "core/cancelled.h"
#include "files/encoded_image.h"
#include "gltf_builder.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

std::stop_token stopped()
{
    std::stop_source source;
    source.request_stop();
    return source.get_token();
}

LoadOptions stoppedOptions()
{
    LoadOptions options;
    options.stop = stopped();
    return options;
}

TEST(StoppedLoading, DecodesNoImage)
{
    const std::vector<std::byte> noPicture(16);
    std::vector<EncodedImage> images(8);
    for (EncodedImage& image : images) {
        image.file = image.name = "damaged";
        image.bytes = noPicture;
    }
    EXPECT_THROW(decodeAll(images), Error);
    EXPECT_THROW(decodeAll(images, stopped()), Cancelled);
    EXPECT_TRUE(decodeAll({}, stopped()).empty()) << "nothing is left that could be stopped";
}

TEST(StoppedLoading, ReadsNoPictureOfAGltfFile)
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    builder.json["images"] = {{{"uri", "missing.png"}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
    const TestFolder folder;
    const auto file = folder.write("model.glb", builder.glb());
    EXPECT_THROW(loadScene(file), Error);
    EXPECT_THROW(loadScene(file, stoppedOptions()), Cancelled);
}

TEST(StoppedLoading, ReadsNoPictureOfAnObjFile)
{
    const TestFolder folder;
    folder.write("m.mtl", std::string("newmtl m\nmap_Kd missing.png\n"));
    const auto file =
        folder.write("model.obj", std::string("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\n"
                                              "f 1/1 2/1 3/1\n"));
    EXPECT_THROW(loadScene(file), Error);
    EXPECT_THROW(loadScene(file, stoppedOptions()), Cancelled);
}

} // namespace
} // namespace torrance
