// Files that something happened to. Whatever it was: a scene or an Error, nothing else. Run it under the `asan` preset.
#include "gltf_builder.h"
#include "mutations.h"
#include "png_bytes.h"

namespace torrance {
namespace {

using test::expectSound;
using test::Random;

/// Some of everything: textures, sparse and strided accessors, a skin, morph targets, instances, a camera, a light.
GltfBuilder everything()
{
    GltfBuilder builder = GltfBuilder::triangle();
    auto& attributes = builder.primitive()["attributes"];
    const int normal = builder.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    const int tangent = builder.addFloats({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4");
    const int uv =
        builder.addAccessor(std::vector<std::uint16_t>{0, 0, 65535, 0, 0, 65535}, gltf::kUnsignedShort, "VEC2", 3);
    builder.accessor(uv)["normalized"] = true;
    const int joints = builder.addAccessor(std::vector<std::uint8_t>{0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0},
                                           gltf::kUnsignedByte, "VEC4", 3);
    const int weights = builder.addFloats({.5f, .5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    const int indices = builder.addAccessor(std::vector<std::uint16_t>{0, 1, 2}, gltf::kUnsignedShort, "SCALAR", 3);
    const int places = builder.addView(std::vector<std::uint8_t>{0, 2});
    const int values = builder.addView(std::vector<float>{0, 0, 1, 0, 0, 2});
    const int target =
        builder.append("accessors", {{"componentType", gltf::kFloat},
                                     {"count", 3},
                                     {"type", "VEC3"},
                                     {"sparse",
                                      {{"count", 2},
                                       {"indices", {{"bufferView", places}, {"componentType", gltf::kUnsignedByte}}},
                                       {"values", {{"bufferView", values}}}}}});
    std::vector<float> identities(32, 0.0f);
    for (std::size_t i = 0; i < 32; ++i)
        identities[i] = i % 16 % 5 == 0 ? 1.0f : 0.0f;
    const int matrices = builder.addFloats(identities, "MAT4");
    const int translations = builder.addFloats({0, 0, 0, 2, 0, 0}, "VEC3");
    test::PngSpec spec;
    spec.scanlines = {0, 10, 20, 30, 40};
    const std::string png = test::pngBytes(spec);
    const int image = builder.addView(std::vector<char>(png.begin(), png.end()));

    attributes["NORMAL"] = normal;
    attributes["TANGENT"] = tangent;
    attributes["TEXCOORD_0"] = uv;
    attributes["JOINTS_0"] = joints;
    attributes["WEIGHTS_0"] = weights;
    builder.primitive()["indices"] = indices;
    builder.primitive()["material"] = 0;
    builder.primitive()["targets"] = {{{"POSITION", target}}};
    builder.json["meshes"][0]["weights"] = {0.5};
    builder.json["images"] = {{{"bufferView", image}, {"mimeType", "image/png"}}};
    builder.json["samplers"] = {{{"minFilter", 9987}, {"wrapS", 33071}}};
    builder.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    builder.json["materials"] = {
        {{"pbrMetallicRoughness",
          {{"baseColorTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"rotation", 0.5}}}}}}},
           {"roughnessFactor", 0.25}}},
         {"alphaMode", "MASK"}}};
    builder.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", matrices}}};
    builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}}};
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"spot", {{"outerConeAngle", 0.5}}}}};
    builder.json["nodes"] = {
        {{"mesh", 0}, {"skin", 0}},
        {{"children", {2, 3}}, {"rotation", {0, 0, 0, 1}}},
        {{"translation", {0, 1, 0}}, {"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
        {{"mesh", 0},
         {"weights", {0.0}},
         {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", translations}}}}}}}}};
    builder.json["scenes"] = {{{"nodes", {0, 1}}}};
    builder.json["extensionsUsed"] = {"KHR_lights_punctual", "EXT_mesh_gpu_instancing", "KHR_texture_transform"};
    return builder;
}

/// True where it loads.
bool survives(const TestFolder& folder, const std::vector<std::byte>& bytes)
{
    const auto path = folder.write("model.glb", bytes);
    try {
        expectSound(loadScene(path).scene);
        return true;
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::input) << error.what();
        return false;
    }
}

TEST(GltfMutations, StartFromAFileThatLoads)
{
    const LoadedScene loaded = load(everything());
    expectSound(loaded.scene);
    EXPECT_TRUE(loaded.warnings.empty());
    EXPECT_EQ(loaded.scene.instances.size(), 3u);
    EXPECT_EQ(loaded.scene.cameras.size(), 1u);
    EXPECT_EQ(loaded.scene.lights.size(), 1u);
    EXPECT_EQ(loaded.scene.images.size(), 1u);
}

TEST(GltfMutations, SurviveChangedBytes)
{
    const TestFolder folder;
    const std::vector<std::byte> whole = everything().glb();
    Random random(1);
    int loaded = 0;
    for (int run = 0; run < 1500 && !HasFatalFailure(); ++run) {
        std::vector<std::byte> bytes = whole;
        for (std::size_t changes = 1 + random.below(4); changes > 0; --changes)
            bytes[random.below(bytes.size())] = static_cast<std::byte>(random.next());
        loaded += survives(folder, bytes) ? 1 : 0;
    }
    EXPECT_GT(loaded, 60) << "most changes should not stop at the first check";
    EXPECT_LT(loaded, 1400);
}

TEST(GltfMutations, SurviveChangedNumbers)
{
    const TestFolder folder;
    const std::string text = everything().json.dump();
    const std::vector<std::string> numbers = {"0",
                                              "-1",
                                              "1",
                                              "2",
                                              "3",
                                              "7",
                                              "255",
                                              "5121",
                                              "65536",
                                              "2147483648",
                                              "9007199254740991",
                                              "18446744073709551615",
                                              "1e300",
                                              "0.5",
                                              "null",
                                              "\"x\"",
                                              "[]",
                                              "{}"};
    std::vector<std::size_t> places;
    for (std::size_t i = 1; i < text.size(); ++i)
        if (std::isdigit(static_cast<unsigned char>(text[i])) &&
            (text[i - 1] == ':' || text[i - 1] == ',' || text[i - 1] == '['))
            places.push_back(i);
    const std::vector<std::byte> binary = everything().binary;
    int loaded = 0;
    for (const std::size_t place : places)
        for (const std::string& number : numbers) {
            const std::size_t end = text.find_first_of(",]}", place);
            const std::string changed = text.substr(0, place) + number + text.substr(end);
            // The document has no buffers of its own: the builder adds them from the size of the binary chunk.
            const std::string whole = changed.substr(0, changed.size() - 1) +
                                      ",\"buffers\":[{\"byteLength\":" + std::to_string(binary.size()) + "}]}";
            loaded += survives(folder, GltfBuilder::glbOf(whole, binary)) ? 1 : 0;
            if (HasFatalFailure())
                return;
        }
    EXPECT_GT(loaded, 100);
}

TEST(GltfMutations, SurviveTruncation)
{
    const TestFolder folder;
    const std::vector<std::byte> whole = everything().glb();
    for (std::size_t length = 0; length < whole.size(); length += 7)
        EXPECT_FALSE(survives(folder, {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)})) << length;
}

} // namespace
} // namespace torrance
