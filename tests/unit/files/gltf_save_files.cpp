// Where a saved file stands, in which form, what it refers to; and that a save that fails leaves everything as it was.
#include "gltf_save_cases.h"

#include "files/image_write.h"
#include "files/texture_file.h"

#include <csignal>
#include <sys/resource.h>

namespace torrance {
namespace {

namespace fs = std::filesystem;
using test::changedPlaces;
using test::joined;
using test::liesIn;
using test::readSaved;
using test::richModel;
using test::saveError;

void roughen(Scene& scene)
{
    scene.materials[0].roughnessFactor = 0.125;
}

double roughnessIn(const fs::path& path, const LoadOptions& options = {})
{
    return loadScene(path, options).scene.materials.at(0).roughnessFactor;
}

/// The rich model as a .gltf whose buffer and picture are files, with names that URIs have to escape.
fs::path writeText(const TestFolder& folder, const std::string& name, int indent = 2)
{
    GltfBuilder builder = richModel();
    builder.json["buffers"][0]["uri"] = "parts%20of%20it/all%23.bin";
    builder.json["images"][0] = {{"uri", "parts of it/p\xc3\xa4int.png"}, {"name", "paint"}};
    builder.json["extensions"]["EXT_nobody_knows"]["files"] = {{{"uri", "parts%20of%20it/sound.ogg"}}};
    const std::string parts = fs::path(name).parent_path() / "parts of it";
    folder.write(parts + "/all#.bin", builder.binary);
    folder.write(parts + "/p\xc3\xa4int.png", test::pngOf(255));
    return folder.write(name, builder.json.dump(indent));
}

TEST(GltfSaveFiles, SaveOverTheirSource)
{
    const TestFolder folder;
    const fs::path path = folder.write("model.glb", richModel().glb());
    const auto before = readSaved(path);
    const LoadedScene loaded = loadScene(path);
    Scene edited = loaded.scene;
    roughen(edited);
    saveGltf(path, loaded.scene, edited, path);
    EXPECT_EQ(roughnessIn(path), 0.125);
    const auto after = readSaved(path);
    EXPECT_TRUE(liesIn(changedPlaces(before.json, after.json), {"/materials/1/pbrMetallicRoughness/roughnessFactor"}));
    EXPECT_EQ(after.binary, before.binary);
    EXPECT_EQ(test::filesIn(folder.path), 1u);

    // And again, from the scene that was saved.
    Scene more = edited;
    more.materials[0].metallicFactor = 0.75;
    saveGltf(path, edited, more, path);
    EXPECT_EQ(loadScene(path).scene.materials.at(0).metallicFactor, 0.75);
}

// However often a file is written over: each time from what it was, which lies somewhere else.
TEST(GltfSaveFiles, AreWrittenOverFromACopyOfWhatTheyWere)
{
    const TestFolder folder, elsewhere;
    const fs::path path = writeText(folder, "model.gltf");
    const fs::path copy = elsewhere.path / "model.gltf";
    fs::copy_file(path, copy);
    LoadOptions ofCopy;
    ofCopy.readAs = path;
    const Scene original = loadScene(path).scene;
    EXPECT_EQ(loadScene(copy, ofCopy).scene.images.size(), original.images.size()) << "from beside the path it had";
    Scene edited = original;
    roughen(edited);
    const GltfSaveOptions fromCopy = {.load = ofCopy, .pictures = {}, .duplicateOf = {}};
    saveGltf(path, original, edited, path);
    saveGltf(copy, original, edited, path, fromCopy);
    EXPECT_EQ(roughnessIn(path), 0.125);
    saveGltf(copy, original, original, path, fromCopy);
    EXPECT_EQ(readSaved(path).json, readSaved(copy).json) << "nothing is left of the edits";

    // What goes wrong with it is said of the path it had.
    fs::remove(folder.path / "parts of it" / "all#.bin");
    try {
        loadScene(copy, ofCopy);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find(path.string()), 0u) << error.what();
    }
}

TEST(GltfSaveFiles, KeepTheIndentationOfText)
{
    for (const int indent : {-1, 1, 2, 4}) {
        const TestFolder folder;
        const fs::path path = writeText(folder, "model.gltf", indent);
        const auto before = readSaved(path);
        const LoadedScene loaded = loadScene(path);
        saveGltf(path, loaded.scene, loaded.scene, path);
        const auto after = readSaved(path);
        EXPECT_EQ(after.json, before.json);
        EXPECT_EQ(after.bytes.size(), before.bytes.size() + 1) << "a line break at the end; indentation " << indent;
    }
}

TEST(GltfSaveFiles, FindWhatTheyReferToFromAnotherFolder)
{
    const TestFolder folder;
    const fs::path path = writeText(folder, "from here/model.gltf");
    const LoadedScene loaded = loadScene(path);
    Scene edited = loaded.scene;
    roughen(edited);
    fs::create_directories(folder.path / "to there/deep");
    const fs::path target = folder.path / "to there/deep/a model.gltf";
    const auto remarks = saveGltf(path, loaded.scene, edited, target);
    const auto saved = readSaved(target);
    EXPECT_EQ(saved.json["buffers"][0]["uri"], "../../from%20here/parts%20of%20it/all%23.bin");
    EXPECT_EQ(saved.json["images"][0]["uri"], "../../from%20here/parts%20of%20it/p%C3%A4int.png");
    EXPECT_EQ(saved.json["extensions"]["EXT_nobody_knows"]["files"][0]["uri"],
              "../../from%20here/parts%20of%20it/sound.ogg");
    EXPECT_EQ(saved.json["extras"]["view"]["uri"], "not ours");
    LoadOptions outside;
    outside.allowExternal = true;
    EXPECT_EQ(roughnessIn(target, outside), 0.125);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_TRUE(contains(remarks[0], "--allow-external")) << remarks[0];

    // A folder above needs no leave, and a link on the way is followed.
    const fs::path above = folder.path / "above.gltf";
    EXPECT_TRUE(saveGltf(path, loaded.scene, edited, above).empty());
    EXPECT_EQ(roughnessIn(above), 0.125);
    fs::create_directory_symlink(folder.path / "to there/deep", folder.path / "link");
    saveGltf(path, loaded.scene, edited, folder.path / "link/linked.gltf");
    EXPECT_EQ(roughnessIn(folder.path / "link/linked.gltf", outside), 0.125);
    fs::create_directory_symlink(folder.path / "from here", folder.path / "same");
    EXPECT_TRUE(saveGltf(path, loaded.scene, edited, folder.path / "same/other.gltf").empty());
    EXPECT_EQ(readSaved(folder.path / "same/other.gltf").json["buffers"][0]["uri"], "parts%20of%20it/all%23.bin");
}

TEST(GltfSaveFiles, TakeNamesWithoutAFolder)
{
    const TestFolder folder;
    writeText(folder, "model.gltf");
    const fs::path before = fs::current_path();
    fs::current_path(folder.path);
    const LoadedScene loaded = loadScene("model.gltf");
    Scene edited = loaded.scene;
    roughen(edited);
    EXPECT_TRUE(saveGltf("model.gltf", loaded.scene, edited, "saved.gltf").empty());
    EXPECT_EQ(roughnessIn("saved.gltf"), 0.125);
    fs::current_path(before);
}

TEST(GltfSaveFiles, HoldEverythingAsGlb)
{
    const TestFolder folder;
    const fs::path path = writeText(folder, "from/model.gltf");
    const LoadedScene loaded = loadScene(path);
    Scene edited = loaded.scene;
    roughen(edited);
    fs::create_directory(folder.path / "to");
    const fs::path target = folder.path / "to/model.GLB";
    saveGltf(path, loaded.scene, edited, target);
    const auto before = readSaved(path);
    const auto after = readSaved(target);
    ASSERT_TRUE(after.isBinary);
    fs::remove_all(folder.path / "from/parts of it");
    LoadOptions outside;
    outside.allowExternal = true; // for the sound, which is nobody's
    EXPECT_EQ(roughnessIn(target, outside), 0.125);
    const std::vector<std::byte> original = richModel().binary;
    EXPECT_TRUE(std::equal(original.begin(), original.end(), after.binary.begin())) << "in front, byte for byte";
    EXPECT_TRUE(liesIn(changedPlaces(before.json, after.json),
                       {"/materials/1/pbrMetallicRoughness/roughnessFactor", "/buffers/0/uri", "/buffers/0/byteLength",
                        "/images/0", "/bufferViews", "/extensions/EXT_nobody_knows/files/0/uri"}))
        << joined(changedPlaces(before.json, after.json));
    EXPECT_EQ(after.json["images"][0].dump(), R"({"name":"paint","bufferView":3,"mimeType":"image/png"})");
    const nlohmann::ordered_json& view = after.json["bufferViews"].back();
    const std::vector<std::byte> picture = test::pngOf(255);
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
    EXPECT_EQ(view["byteLength"], picture.size());
    EXPECT_TRUE(
        std::equal(picture.begin(), picture.end(), after.binary.begin() + view["byteOffset"].get<std::ptrdiff_t>()));
}

TEST(GltfSaveFiles, HoldSeveralBuffersAsGlb)
{
    const TestFolder folder;
    GltfBuilder builder = richModel();
    builder.json["buffers"][0]["uri"] = "first.bin";
    folder.write("first.bin", builder.binary);
    folder.write("second.bin", std::string(40, '\x3f')); // three vectors of floats, and more than is asked for
    builder.json["buffers"].push_back({{"uri", "second.bin"}, {"byteLength", 36}});
    builder.json["buffers"].push_back({{"uri", "missing.bin"}, {"byteLength", 36}});
    builder.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 36}});
    const int normal =
        builder.append("accessors", {{"bufferView", 3}, {"componentType", 5126}, {"type", "VEC3"}, {"count", 3}});
    builder.json["meshes"][1]["primitives"][0]["attributes"]["NORMAL"] = normal;
    const fs::path path = folder.write("model.gltf", builder.json.dump());
    const LoadedScene loaded = loadScene(path);
    Scene edited = loaded.scene;
    roughen(edited);
    const auto remarks = saveGltf(path, loaded.scene, edited, folder.path / "a.glb");
    const auto saved = readSaved(folder.path / "a.glb");
    EXPECT_FALSE(saved.json["buffers"][0].contains("uri"));
    EXPECT_TRUE(
        saved.json["buffers"][1]["uri"].get<std::string>().starts_with("data:application/octet-stream;base64,"));
    EXPECT_EQ(saved.json["buffers"][2]["uri"], "missing.bin") << "that no view uses, and so loading did not miss";
    ASSERT_EQ(remarks.size(), 1u) << joined(remarks);
    EXPECT_TRUE(contains(remarks[0], "/buffers/2")) << remarks[0];
    fs::remove(folder.path / "first.bin");
    fs::remove(folder.path / "second.bin");
    EXPECT_EQ(roughnessIn(folder.path / "a.glb"), 0.125);
}

TEST(GltfSaveFiles, BecomeOneTextFromAGlb)
{
    const TestFolder folder;
    const fs::path path = folder.write("model.glb", richModel().glb());
    const LoadedScene loaded = loadScene(path);
    Scene edited = loaded.scene;
    roughen(edited);
    const fs::path target = folder.path / "model.gltf";
    EXPECT_TRUE(saveGltf(path, loaded.scene, edited, target).empty());
    const auto before = readSaved(path);
    const auto after = readSaved(target);
    EXPECT_FALSE(after.isBinary);
    EXPECT_EQ(test::filesIn(folder.path), 2u);
    EXPECT_EQ(roughnessIn(target), 0.125);
    EXPECT_TRUE(liesIn(changedPlaces(before.json, after.json),
                       {"/materials/1/pbrMetallicRoughness/roughnessFactor", "/buffers/0/uri"}));

    // And back: the same bytes, so that neither way lost any.
    saveGltf(target, edited, edited, folder.path / "back.glb");
    const auto back = readSaved(folder.path / "back.glb");
    EXPECT_EQ(back.binary, before.binary);
    EXPECT_TRUE(liesIn(changedPlaces(before.json, back.json), {"/materials/1/pbrMetallicRoughness/roughnessFactor"}));
}

TEST(GltfSaveFiles, KeepChunksOfExtensions)
{
    const TestFolder folder;
    std::vector<std::byte> bytes = richModel().glb();
    const std::string chunk("\x04\0\0\0XYZ1data", 12);
    for (const char c : chunk)
        bytes.push_back(static_cast<std::byte>(c));
    const auto size = static_cast<std::uint32_t>(bytes.size());
    std::memcpy(bytes.data() + 8, &size, sizeof size);
    const fs::path path = folder.write("model.glb", bytes);
    const LoadedScene loaded = loadScene(path);
    Scene edited = loaded.scene;
    roughen(edited);
    EXPECT_TRUE(saveGltf(path, loaded.scene, edited, folder.path / "a.glb").empty());
    const auto saved = readSaved(folder.path / "a.glb");
    EXPECT_EQ(std::memcmp(saved.bytes.data() + saved.bytes.size() - chunk.size(), chunk.data(), chunk.size()), 0);
    const auto remarks = saveGltf(path, loaded.scene, edited, folder.path / "a.gltf");
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_TRUE(contains(remarks[0], "chunks of extensions")) << remarks[0];
}

// glTF 2.0, 4.4: lengths in the headers, chunks filled up to multiples of four, spaces after JSON, zeros after bytes.
TEST(GltfSaveFiles, FillChunksUpAsGlbWantsIt)
{
    for (std::size_t length = 1; length <= 5; ++length) {
        const TestFolder folder;
        const fs::path path = folder.write("model.glb", richModel().glb());
        const LoadedScene loaded = loadScene(path);
        Scene edited = loaded.scene;
        edited.materials[0].name = std::string(length, 'x');
        folder.write("picture.png", test::pngOf(0));
        edited.images.push_back(loadScene(path).scene.images[0]);
        edited.images.back().texels[0] = std::byte{0};
        edited.textures.push_back({1, {}});
        edited.materials[0].baseColor.texture = 2;
        GltfSaveOptions options;
        options.pictures = {folder.path / "picture.png"};
        saveGltf(path, loaded.scene, edited, folder.path / "a.glb", options);
        const std::vector<std::byte> bytes = readSaved(folder.path / "a.glb").bytes;
        const auto word = [&](std::size_t offset) {
            std::uint32_t value = 0;
            std::memcpy(&value, bytes.data() + offset, sizeof value);
            return std::size_t(value);
        };
        EXPECT_EQ(word(8), bytes.size());
        const std::size_t json = word(12);
        EXPECT_EQ(json % 4, 0u);
        for (std::size_t i = 20 + json; bytes[--i] != std::byte{'}'};)
            EXPECT_EQ(bytes[i], std::byte{' '});
        const std::size_t binary = word(20 + json);
        EXPECT_EQ(binary % 4, 0u);
        EXPECT_EQ(28 + json + binary, bytes.size());
        const std::size_t used = readSaved(folder.path / "a.glb").json["buffers"][0]["byteLength"];
        EXPECT_LE(used, binary);
        EXPECT_LT(binary - used, 4u) << "glTF 2.0, 4.4.3.3: the chunk may be up to 3 bytes longer";
        for (std::size_t i = used; i < binary; ++i)
            EXPECT_EQ(bytes[28 + json + i], std::byte{0});
    }
}

Scene withPicture(Scene scene, std::uint8_t red, const Sampler& sampler = {})
{
    scene.images.push_back(scene.images.at(0));
    scene.images.back().texels[0] = std::byte{red};
    scene.textures.push_back({static_cast<int>(scene.images.size()) - 1, sampler});
    scene.materials[1].baseColor.texture = static_cast<int>(scene.textures.size()) - 1;
    return scene;
}

TEST(GltfSaveFiles, CopyNewPicturesIntoAGlb)
{
    const TestFolder folder;
    const fs::path path = folder.write("model.glb", richModel().glb());
    const fs::path picture = folder.write("else where/new one.png", test::pngOf(7));
    const LoadedScene loaded = loadScene(path);
    Sampler edge;
    edge.wrapS = Wrap::clampToEdge;
    edge.magnify = Filter::nearest;
    Sampler other = edge;
    other.mip = MipFilter::none;
    Scene edited = withPicture(loaded.scene, 7, edge);
    edited.textures.push_back({1, other});
    edited.textures.push_back({0, {}});
    edited.materials[1].normal.texture = 3;
    edited.materials[1].emissive.texture = 4;
    GltfSaveOptions options;
    options.pictures = {picture};
    saveGltf(path, loaded.scene, edited, folder.path / "a.glb", options);
    const auto before = readSaved(path);
    const auto saved = readSaved(folder.path / "a.glb");
    fs::remove(picture);

    const LoadedScene after = loadScene(folder.path / "a.glb");
    const Scene& scene = after.scene;
    const auto textureOf = [&](const TextureUse& use) {
        return scene.textures.at(static_cast<std::size_t>(use.texture));
    };
    const Texture color = textureOf(scene.materials.at(1).baseColor);
    EXPECT_EQ(scene.images.at(static_cast<std::size_t>(color.image)).texels.at(0), std::byte{7});
    EXPECT_EQ(color.sampler, edge);
    EXPECT_EQ(textureOf(scene.materials.at(1).normal).sampler, other);
    EXPECT_EQ(textureOf(scene.materials.at(1).emissive).sampler, Sampler{});
    EXPECT_EQ(saved.json["textures"][2].dump(), R"({"sampler":0,"source":1})") << "a sampler that was there";
    EXPECT_EQ(saved.json["textures"][3].dump(), R"({"sampler":1,"source":1})") << "a new one";
    EXPECT_EQ(saved.json["textures"][4].dump(), R"({"source":0})");
    EXPECT_EQ(saved.json["images"].size(), 2u);
    EXPECT_TRUE(std::equal(before.binary.begin(), before.binary.end(), saved.binary.begin()));
    EXPECT_TRUE(
        liesIn(changedPlaces(before.json, saved.json),
               {"/materials/2", "/textures/-", "/images/-", "/samplers/-", "/bufferViews/-", "/buffers/0/byteLength"}))
        << joined(changedPlaces(before.json, saved.json));
}

TEST(GltfSaveFiles, NameNewPicturesInText)
{
    const TestFolder folder;
    const fs::path path = writeText(folder, "model.gltf");
    const fs::path picture = folder.write("new ones/a:b #1.png", test::pngOf(7));
    const LoadedScene loaded = loadScene(path);
    const Scene edited = withPicture(loaded.scene, 7);
    GltfSaveOptions options;
    options.pictures = {picture};
    EXPECT_TRUE(saveGltf(path, loaded.scene, edited, folder.path / "a.gltf", options).empty());
    EXPECT_EQ(readSaved(folder.path / "a.gltf").json["images"][1]["uri"], "new%20ones/a%3Ab%20%231.png");
    const Scene after = loadScene(folder.path / "a.gltf").scene;
    EXPECT_EQ(after.images.at(1).texels.at(0), std::byte{7});

    const TestFolder other;
    options.pictures = {other.write("far.png", test::pngOf(7))};
    const auto remarks = saveGltf(path, loaded.scene, edited, folder.path / "b.gltf", options);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_TRUE(contains(remarks[0], "far.png")) << remarks[0];
}

// EXT_texture_webp: without a picture in another format to fall back to, the extension is required.
TEST(GltfSaveFiles, TakeWebp)
{
    const TestFolder folder;
    const fs::path path = folder.write("model.glb", richModel().glb());
    const Image white(2, 1, 3, 1.0f);
    WriteSettings lossless;
    lossless.quality = 100;
    const fs::path picture = folder.write("new.webp", encodePicture(ImageFormat::webp, white, {}, lossless));
    const LoadedScene loaded = loadScene(path);
    Scene edited = loaded.scene;
    edited.images.push_back(decodeTexture(readFile(picture, "", ""), "", ""));
    edited.textures.push_back({1, {}});
    edited.materials[1].baseColor.texture = 2;
    GltfSaveOptions options;
    options.pictures = {picture};
    const fs::path target = folder.path / "a.glb";
    saveGltf(path, loaded.scene, edited, target, options);
    const auto saved = readSaved(target);
    EXPECT_EQ(saved.json["textures"][2].dump(), R"({"extensions":{"EXT_texture_webp":{"source":1}}})");
    EXPECT_EQ(saved.json["images"][1]["mimeType"], "image/webp");
    EXPECT_EQ(saved.json["extensionsRequired"].dump(), R"(["EXT_texture_webp"])");
    EXPECT_EQ(saved.json["extensionsUsed"].back(), "EXT_texture_webp");

    // A further texture of the picture, which is in the file by now.
    const LoadedScene again = loadScene(target);
    edited = again.scene;
    Sampler edge;
    edge.wrapT = Wrap::clampToEdge;
    edited.textures.push_back({again.scene.textures.back().image, edge});
    edited.materials[1].normal.texture = static_cast<int>(edited.textures.size()) - 1;
    saveGltf(target, again.scene, edited, target);
    EXPECT_EQ(readSaved(target).json["textures"][3].dump(),
              R"({"sampler":1,"extensions":{"EXT_texture_webp":{"source":1}}})");
}

// Nothing is decoded: what other programs compressed lies where it lay, and its views keep their numbers.
TEST(GltfSaveFiles, PassCompressedGeometryThrough)
{
    const TestFolder folder;
    GltfBuilder builder = richModel();
    const int compressed = builder.addView(std::vector<std::uint8_t>{1, 2, 3, 4, 5});
    builder.json["buffers"][0]["byteLength"] = builder.binary.size();
    builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", compressed}, {"attributes", {{"POSITION", 0}}}};
    builder.view(0)["extensions"]["EXT_meshopt_compression"] = {
        {"buffer", 0}, {"byteOffset", 0}, {"byteLength", 5}, {"byteStride", 12}, {"mode", "ATTRIBUTES"}, {"count", 3}};
    const fs::path path = folder.write("model.glb", builder.glb());
    const LoadedScene loaded = loadScene(path);
    GltfSaveOptions options;
    options.pictures = {folder.write("new.png", test::pngOf(7))};
    saveGltf(path, loaded.scene, withPicture(loaded.scene, 7), folder.path / "a.glb", options);
    const auto before = readSaved(path);
    const auto after = readSaved(folder.path / "a.glb");
    EXPECT_EQ(after.json["meshes"], before.json["meshes"]);
    EXPECT_TRUE(liesIn(changedPlaces(before.json, after.json),
                       {"/materials/2", "/textures/-", "/images/-", "/bufferViews/-", "/buffers/0/byteLength"}));
    EXPECT_TRUE(std::equal(before.binary.begin(), before.binary.end(), after.binary.begin()));
}

TEST(GltfSaveFiles, PutPicturesIntoUrisWhereAGlbHasNoChunk)
{
    const TestFolder folder;
    GltfBuilder builder = richModel();
    builder.json["buffers"][0]["uri"] = "all.bin";
    folder.write("all.bin", builder.binary);
    const fs::path path = folder.write("model.glb", GltfBuilder::glbOf(builder.json.dump(), {}));
    const LoadedScene loaded = loadScene(path);
    GltfSaveOptions options;
    options.pictures = {folder.write("new.png", test::pngOf(7))};
    saveGltf(path, loaded.scene, withPicture(loaded.scene, 7), folder.path / "a.glb", options);
    const auto saved = readSaved(folder.path / "a.glb");
    EXPECT_TRUE(saved.json["images"][1]["uri"].get<std::string>().starts_with("data:image/png;base64,"));
    EXPECT_EQ(saved.json["buffers"], readSaved(path).json["buffers"]);
}

TEST(GltfSaveFiles, RefuseOtherPictures)
{
    const TestFolder folder;
    const fs::path path = folder.write("model.glb", richModel().glb());
    const LoadedScene loaded = loadScene(path);
    const Scene edited = withPicture(loaded.scene, 7);
    const fs::path target = folder.path / "a.glb";
    const auto errorWith = [&](const fs::path& picture, ExitCode code) {
        GltfSaveOptions options;
        options.pictures = {picture};
        return saveError(path, loaded.scene, edited, target, code, options);
    };
    EXPECT_TRUE(contains(errorWith(folder.path / "none.png", ExitCode::input), "none.png: no such file"));
    EXPECT_TRUE(contains(errorWith(folder.write("a.png", std::string("BM bitmap")), ExitCode::input), "use PNG, JPEG"));
    EXPECT_TRUE(contains(errorWith(folder.write("b.png", test::pngOf(8)), ExitCode::cannotWrite),
                         "the picture of /textures/2 would read back otherwise"))
        << "it changed since it was decoded";
    EXPECT_FALSE(fs::exists(target));
}

TEST(GltfSaveFiles, RefuseAFileThatChanged)
{
    const TestFolder folder;
    const fs::path path = folder.write("model.glb", richModel().glb());
    const LoadedScene loaded = loadScene(path);
    Scene edited = loaded.scene;
    roughen(edited);
    const auto message = [&] { return saveError(path, loaded.scene, edited, path, ExitCode::input); };

    GltfBuilder other = richModel();
    other.json["materials"][1]["pbrMetallicRoughness"]["metallicFactor"] = 0.25;
    folder.write("model.glb", other.glb());
    EXPECT_TRUE(contains(message(), "model.glb: has changed since it was loaded")) << message();
    EXPECT_EQ(readSaved(path).bytes, other.glb()) << "and stays as it is now";

    other = richModel();
    other.binary[0] = std::byte{1};
    folder.write("model.glb", other.glb());
    EXPECT_TRUE(contains(message(), "has changed since it was loaded")) << "its geometry";
    fs::remove(path);
    EXPECT_TRUE(contains(message(), "no such file"));
}

TEST(GltfSaveFiles, RefuseOtherFormats)
{
    const TestFolder folder;
    const fs::path obj = folder.write("model.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    const Scene scene = loadScene(obj).scene;
    EXPECT_TRUE(contains(saveError(obj, scene, scene, folder.path / "a.glb", ExitCode::usage),
                         "saved for .gltf and .glb, not for OBJ; convert the model to glTF"));
    const fs::path glb = folder.write("model.glb", richModel().glb());
    const Scene rich = loadScene(glb).scene;
    for (const char* name : {"a.obj", "a", "a.json", "/dev/null"})
        EXPECT_TRUE(
            contains(saveError(glb, rich, rich, folder.path / name, ExitCode::usage), "saved to .gltf and .glb"));
}

TEST(GltfSaveFiles, LeaveNothingWhereTheyCannotBeWritten)
{
    const TestFolder folder;
    const fs::path path = folder.write("model.glb", richModel().glb());
    fs::create_directory(folder.path / "folder.glb");
    folder.write("file", std::string("no folder"));
    fs::create_symlink("/dev/full", folder.path / "full.glb");
    const Scene scene = loadScene(path).scene;
    for (const fs::path& target : {folder.path / "none/a.glb", folder.path / "folder.glb", folder.path / "file/a.glb",
                                   folder.path / "full.glb", fs::path("/proc/a.glb")})
        EXPECT_NE(saveError(path, scene, scene, target, ExitCode::cannotWrite), "") << target;
    EXPECT_EQ(test::filesIn(folder.path), 4u);
}

TEST(GltfSaveFiles, LeaveTheOldFileWhereTheDiskIsFull)
{
    const TestFolder folder;
    GltfBuilder builder = richModel();
    builder.json["extras"]["long"] = std::string(20000, 'x');
    const fs::path path = folder.write("model.glb", builder.glb());
    const LoadedScene loaded = loadScene(path);
    Scene edited = loaded.scene;
    roughen(edited);
    // A file that grows beyond the limit fails to, as on a full disk.
    rlimit before = {};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small = {.rlim_cur = 8192, .rlim_max = before.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string message = saveError(path, loaded.scene, edited, path, ExitCode::cannotWrite);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_TRUE(contains(message, "choose a writable place with free space")) << message;
    EXPECT_EQ(readSaved(path).bytes, builder.glb());
    EXPECT_EQ(test::filesIn(folder.path), 1u);
}

TEST(GltfSaveFiles, SaveTheSceneThatWasChosen)
{
    const TestFolder folder;
    GltfBuilder builder = richModel();
    builder.json["scenes"].push_back({{"nodes", {2}}});
    const fs::path path = folder.write("model.glb", builder.glb());
    GltfSaveOptions options;
    options.load.scene = 1;
    const LoadedScene loaded = loadScene(path, options.load);
    ASSERT_EQ(loaded.scene.materials.size(), 1u);
    Scene edited = loaded.scene;
    roughen(edited);
    saveGltf(path, loaded.scene, edited, path, options);
    EXPECT_EQ(readSaved(path).json["materials"][2]["pbrMetallicRoughness"]["roughnessFactor"], 0.125);
    EXPECT_EQ(loadScene(path).scene.materials.at(0).roughnessFactor, 0.6);
}

// The demo scene, which tools/make_assets writes while building.
TEST(GltfSaveFiles, SaveTheDemoScene)
{
    const fs::path path = fs::path(TORRANCE_BINARY_DIR) / "share/torrance/assets/demo/demo.gltf";
    if (!fs::exists(path))
        GTEST_SKIP() << "it was not built";
    const TestFolder folder;
    const LoadedScene loaded = loadScene(path);
    Scene edited = loaded.scene;
    roughen(edited);
    for (const char* name : {"demo.gltf", "demo.glb"}) {
        saveGltf(path, loaded.scene, edited, folder.path / name);
        LoadOptions outside;
        outside.allowExternal = true;
        EXPECT_EQ(roughnessIn(folder.path / name, outside), 0.125);
    }
    const int material = loaded.items.materials.at(0);
    EXPECT_TRUE(liesIn(changedPlaces(readSaved(path).json, readSaved(folder.path / "demo.gltf").json),
                       {"/materials/" + std::to_string(material), "/buffers", "/images"}));
}

} // namespace
} // namespace torrance
