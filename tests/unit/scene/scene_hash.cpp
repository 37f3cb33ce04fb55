#include "scene/scene_hash.h"

#include <functional>
#include <gtest/gtest.h>
#include <set>

namespace torrance {
namespace {

Scene sceneOfEverything()
{
    Scene scene;
    scene.primitives.emplace_back().positions = {vec3(0.0f), vec3(1.0f)};
    scene.instances.emplace_back();
    scene.shapes.emplace_back();
    scene.materials.emplace_back();
    scene.textures.emplace_back();
    scene.images.emplace_back().texels.resize(8);
    scene.lights.emplace_back();
    scene.cameras.emplace_back();
    scene.environment.emplace().radiance = Image(4, 2, 3);
    return scene;
}

std::string hashOf(const Scene& scene)
{
    ContentHasher hasher;
    addToHash(hasher, scene);
    return hasher.finish().hex();
}

TEST(SceneHash, ChangesWithEveryPartOfAScene)
{
    const std::vector<std::function<void(Scene&)>> changes = {
        [](Scene&) {},
        [](Scene& s) { s.primitives[0].positions[1].y = 2.0f; },
        [](Scene& s) { s.primitives[0].uvs[1] = {vec2(0.5f)}; },
        [](Scene& s) { s.primitives[0].uvs[0] = {vec2(0.5f)}; },
        [](Scene& s) { s.primitives[0].indices = {1}; },
        [](Scene& s) { s.instances[0].worldFromObject[3].x = 1.0; },
        [](Scene& s) { s.instances.emplace_back(); },
        [](Scene& s) { s.shapes[0].kind = AnalyticShape::Kind::plane; },
        [](Scene& s) { s.materials[0].metallicFactor = 0.5; },
        [](Scene& s) { s.materials[0].emissive.texture = 0; },
        [](Scene& s) { s.materials[0].occlusion.texture = 0; },
        [](Scene& s) { s.materials[0].unlit = true; },
        [](Scene& s) { s.materials[0].doubleSided = true; },
        [](Scene& s) { s.textures[0].sampler.minify = Filter::nearest; },
        [](Scene& s) { s.textures[0].sampler.magnify = Filter::nearest; },
        [](Scene& s) { s.images[0].texels[7] = std::byte(1); },
        [](Scene& s) { s.images[0].texels[0] = std::byte(1); },
        [](Scene& s) { s.lights[0].radius = 0.1; },
        [](Scene& s) { s.lights[0].range = 0.1; },
        [](Scene& s) { s.cameras[0].xmag = 2.0; },
        [](Scene& s) { s.environment->rotation = 1.0; },
        [](Scene& s) { s.environment->radiance.texels[23] = 1.0f; },
        [](Scene& s) { s.environment.reset(); },
    };
    std::set<std::string> hashes;
    for (const auto& change : changes) {
        Scene scene = sceneOfEverything();
        change(scene);
        hashes.insert(hashOf(scene));
    }
    EXPECT_EQ(hashes.size(), changes.size());
    EXPECT_EQ(hashOf(sceneOfEverything()), hashOf(sceneOfEverything()));
}

} // namespace
} // namespace torrance
