// Saves of files that something happened to: whatever loads is saved or refused in one line. Run it under the `asan`
// preset.
#include "gltf_save_cases.h"
#include "mutations.h"

namespace torrance {
namespace {

using test::Random;

/// Another value where one of the document's stands.
void changeSomething(nlohmann::json& json, Random& random)
{
    nlohmann::json flat = json.flatten();
    auto member = flat.begin();
    std::advance(member, static_cast<std::ptrdiff_t>(random.below(flat.size())));
    const nlohmann::json values[] = {nullptr,
                                     true,
                                     -1,
                                     0,
                                     1,
                                     2,
                                     1e300,
                                     4294967296u,
                                     "",
                                     "../a b.png",
                                     "data:,x",
                                     nlohmann::json::object(),
                                     nlohmann::json::array()};
    json[nlohmann::json::json_pointer(member.key())] = values[random.below(std::size(values))];
}

/// Everything that an edit can touch.
Scene editedThroughout(Scene scene)
{
    for (Material& material : scene.materials) {
        material.name += "!";
        material.roughnessFactor = 0.125;
        material.unlit = !material.unlit;
        material.ior = material.ior == 1.5 ? 1.25 : 1.5;
        material.emissiveFactor = dvec3(0.5, 3.0, 0.1);
        for (TextureUse* use : {&material.baseColor, &material.normal, &material.occlusion}) {
            use->texture = use->used() || scene.textures.empty() ? -1 : 0;
            use->transform[2] = dvec2(0.25, 0.5);
        }
    }
    scene.materials.push_back({});
    for (Primitive& primitive : scene.primitives)
        primitive.material = static_cast<int>(scene.materials.size()) - 1;
    return scene;
}

TEST(GltfSaveMutations, EndInAFileThatLoadsOrInAnError)
{
    Random random(7);
    int saved = 0, refused = 0, loaded = 0;
    for (int i = 0; i < 1000; ++i) {
        const TestFolder folder;
        GltfBuilder builder = test::richModel();
        for (std::size_t changes = 1 + random.below(2); changes-- > 0;)
            changeSomething(builder.json, random);
        const auto path = folder.write("model.glb", builder.glb());
        LoadedScene before;
        try {
            before = loadScene(path);
        } catch (const Error&) {
            continue;
        }
        ++loaded;
        const auto target = folder.path / (i % 2 == 0 ? "saved.glb" : "saved.gltf");
        try {
            saveGltf(path, before.scene, editedThroughout(before.scene), target);
        } catch (const Error& error) {
            ++refused;
            EXPECT_FALSE(contains(error.what(), "\n")) << error.what();
            EXPECT_FALSE(std::filesystem::exists(target)) << error.what();
            continue;
        }
        ++saved;
        LoadOptions outside;
        outside.allowExternal = true;
        EXPECT_NO_THROW(loadScene(target, outside)) << builder.json.dump();
    }
    EXPECT_GT(saved, 150) << "of " << loaded << " that load, " << refused << " refused";
}

} // namespace
} // namespace torrance
