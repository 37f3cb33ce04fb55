#include "view/saved_scene.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

// One material and texture of a file's, and two textures that were added.
struct Shown
{
    Scene scene;
    std::vector<std::filesystem::path> pictures = {"/a.png", "/b.png"};
    EditHistory history;

    Shown() : scene(read()), history(editsOf(scene, {}))
    {
        for (const char* name : {"a", "b"}) {
            scene.images.emplace_back().name = name;
            scene.textures.push_back({.image = static_cast<int>(scene.images.size()) - 1, .sampler = {}});
        }
    }
    static Scene read()
    {
        Scene scene;
        scene.materials.resize(1);
        scene.materials[0].baseColor.texture = 0;
        scene.images.emplace_back().name = "own";
        scene.textures.push_back({.image = 0, .sampler = {}});
        scene.primitives.resize(1);
        return scene;
    }
};

TEST(SceneToSave, HoldsTheSceneAsItWasReadAndAsItIsNow)
{
    Shown shown;
    Edits edits = shown.history.now();
    edits.materials[0].roughnessFactor = 0.5;
    edits.materials.push_back(edits.materials[0]);
    edits.duplicateOf.push_back(0);
    edits.primitiveMaterials[0] = 1;
    shown.history.commit(edits);
    const SceneToSave save = sceneToSave(shown.history, shown.scene, shown.pictures);
    EXPECT_EQ(save.original.materials.size(), 1u);
    EXPECT_EQ(save.original.materials[0].roughnessFactor, 1.0);
    EXPECT_EQ(save.original.primitives[0].material, -1);
    EXPECT_EQ(save.edited.materials.size(), 2u);
    EXPECT_EQ(save.edited.primitives[0].material, 1);
    EXPECT_EQ(save.duplicateOf, std::vector<int>{0});
}

TEST(SceneToSave, LeavesOutPicturesThatNothingReads)
{
    Shown shown;
    Edits edits = shown.history.now();
    edits.materials[0].normal.texture = 2; // b
    shown.history.commit(edits);
    const SceneToSave save = sceneToSave(shown.history, shown.scene, shown.pictures);
    EXPECT_EQ(save.original.images.size(), 1u);
    EXPECT_EQ(save.original.textures.size(), 1u);
    ASSERT_EQ(save.edited.images.size(), 2u);
    EXPECT_EQ(save.edited.images[1].name, "b");
    EXPECT_EQ(save.edited.textures[1].image, 1);
    EXPECT_EQ(save.edited.materials[0].normal.texture, 1);
    EXPECT_EQ(save.edited.materials[0].baseColor.texture, 0);
    EXPECT_EQ(save.pictures, std::vector<std::filesystem::path>{"/b.png"});
}

} // namespace
} // namespace torrance
