#include "view/edits.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

Scene twoMaterials()
{
    Scene scene;
    scene.materials.resize(2);
    scene.primitives.resize(3);
    scene.primitives[2].material = 1;
    scene.lights.resize(1);
    return scene;
}

EditHistory historyOf(const Scene& scene)
{
    return EditHistory(editsOf(scene, {}));
}

Edits rougher(const EditHistory& history, double roughness)
{
    Edits edits = history.now();
    edits.materials[0].roughnessFactor = roughness;
    return edits;
}

TEST(Edits, ReachTheSceneAndComeBack)
{
    Scene scene = twoMaterials();
    scene.environment.emplace();
    Edits edits = editsOf(scene, {.name = "sky"});
    EXPECT_EQ(edits.primitiveMaterials, (std::vector<int>{-1, -1, 1}));
    edits.materials[1].metallicFactor = 0.25;
    edits.primitiveMaterials[0] = 1;
    edits.lights.clear();
    edits.environment.rotation = 90.0;
    edits.environment.intensity = 2.0;
    applyEdits(edits, scene);
    EXPECT_EQ(scene.materials[1].metallicFactor, 0.25);
    EXPECT_EQ(scene.primitives[0].material, 1);
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_DOUBLE_EQ(scene.environment->rotation, kPi / 2.0);
    EXPECT_EQ(scene.environment->intensity, 2.0);
    EXPECT_EQ(editsOf(scene, edits.environment), edits);
}

TEST(Edits, AMaterialOfAFileKeepsTheTexturesThatAreThere)
{
    Material textured, pure;
    textured.name = "old";
    textured.normal.texture = 3;
    textured.normalScale = 0.5;
    textured.roughnessFactor = 0.1;
    pure.name = "gold";
    pure.roughnessFactor = 0.7;
    const Material both = withTexturesOf(textured, pure);
    EXPECT_EQ(both.name, "gold");
    EXPECT_EQ(both.roughnessFactor, 0.7);
    EXPECT_EQ(both.normal.texture, 3);
    EXPECT_EQ(both.normalScale, 0.5);
}

TEST(EditHistory, GoesBackAndForth)
{
    EditHistory history = historyOf(twoMaterials());
    EXPECT_FALSE(history.canUndo());
    history.commit(rougher(history, 0.5));
    history.commit(rougher(history, 0.25));
    history.undo();
    EXPECT_EQ(history.now().materials[0].roughnessFactor, 0.5);
    history.undo();
    EXPECT_EQ(history.now().materials[0].roughnessFactor, 1.0);
    EXPECT_FALSE(history.canUndo());
    history.undo(); // nothing
    history.redo();
    history.redo();
    EXPECT_EQ(history.now().materials[0].roughnessFactor, 0.25);
    EXPECT_FALSE(history.canRedo());
}

TEST(EditHistory, ForgetsWhatWasGoneBackFromWhereSomethingElseIsDone)
{
    EditHistory history = historyOf(twoMaterials());
    history.commit(rougher(history, 0.5));
    history.undo();
    history.commit(rougher(history, 0.75));
    EXPECT_FALSE(history.canRedo());
    history.undo();
    EXPECT_EQ(history.now().materials[0].roughnessFactor, 1.0);
}

TEST(EditHistory, APreviewIsShownAndIsNoStep)
{
    EditHistory history = historyOf(twoMaterials());
    history.preview(rougher(history, 0.5));
    EXPECT_EQ(history.shown().materials[0].roughnessFactor, 0.5);
    EXPECT_EQ(history.now().materials[0].roughnessFactor, 1.0);
    EXPECT_FALSE(history.canUndo());
    history.commit(rougher(history, 0.4));
    EXPECT_EQ(history.shown().materials[0].roughnessFactor, 0.4);
    history.undo();
    EXPECT_EQ(history.shown().materials[0].roughnessFactor, 1.0);
}

TEST(EditHistory, WhatChangesNothingIsNoStep)
{
    EditHistory history = historyOf(twoMaterials());
    history.commit(history.now());
    EXPECT_FALSE(history.canUndo());
}

TEST(EditHistory, KnowsWhatWasNotSaved)
{
    EditHistory history = historyOf(twoMaterials());
    Edits edits = history.now();
    edits.environment.rotation = 10.0;
    history.commit(edits);
    EXPECT_FALSE(history.isDirty()); // no file holds the environment
    history.commit(rougher(history, 0.5));
    EXPECT_TRUE(history.isDirty());
    history.markSaved(history.now());
    EXPECT_FALSE(history.isDirty());
    history.undo();
    EXPECT_TRUE(history.isDirty());
    history.redo();
    EXPECT_FALSE(history.isDirty());
    edits = history.now();
    edits.primitiveMaterials[0] = 1;
    history.commit(edits);
    EXPECT_TRUE(history.isDirty());
    EXPECT_EQ(history.loaded(), editsOf(twoMaterials(), {}));
}

TEST(EditHistory, IsBounded)
{
    EditHistory history = historyOf(twoMaterials());
    for (std::size_t i = 0; i < kMostUndoSteps + 10; ++i)
        history.commit(rougher(history, 1.0 / double(i + 2)));
    std::size_t steps = 0;
    for (; history.canUndo(); ++steps)
        history.undo();
    EXPECT_EQ(steps, kMostUndoSteps);
}

Edits twoMaterials(double roughness)
{
    Edits edits;
    edits.materials.resize(2);
    edits.materials[0].roughnessFactor = roughness;
    edits.materials[1].baseColor.texture = 0;
    edits.primitiveMaterials = {0, 1};
    return edits;
}

TEST(EditHistory, GoesOnAfterItsSceneWasSavedAndReadAgain)
{
    EditHistory history(twoMaterials(0.5));
    history.commit(twoMaterials(0.25));
    Edits lit = twoMaterials(0.25);
    lit.lights.resize(1);
    history.commit(lit);
    ASSERT_TRUE(history.goOnWith(twoMaterials(0.25), 1));
    EXPECT_FALSE(history.isDirty());
    EXPECT_EQ(history.now().lights.size(), 1u) << "no part of the file";
    history.undo();
    history.undo();
    EXPECT_EQ(history.now().materials[0].roughnessFactor, 0.5);
    EXPECT_TRUE(history.isDirty()) << "the file holds 0.25";
}

TEST(EditHistory, EndsWhereItsStatesMeanSomethingElse)
{
    const auto after = [](const Edits& first, const Edits& now) {
        EditHistory history(first);
        history.commit(now);
        return history;
    };
    EXPECT_FALSE(after(twoMaterials(0.5), twoMaterials(0.25)).goOnWith(twoMaterials(0.75), 1)) << "another file";
    EXPECT_FALSE(after(twoMaterials(0.5), twoMaterials(0.25)).goOnWith(twoMaterials(0.25), 0)) << "a texture less";
    Edits three = twoMaterials(0.25);
    three.materials.emplace_back();
    three.duplicateOf = {0};
    EditHistory duplicated = after(twoMaterials(0.5), three);
    EXPECT_FALSE(duplicated.goOnWith(three, 1)) << "the state before has no third";
    EXPECT_TRUE(duplicated.canUndo()) << "nothing was changed";
    EXPECT_EQ(duplicated.now().duplicateOf.size(), 1u);
}

} // namespace
} // namespace torrance
