// The pictures of surface parameters (--aov), against rays cast on the CPU.
#include "passes/layers.h"
#include "mesh_truth.h"
#include "reference/surface_targets.h"
#include "scene/camera_fit.h"
#include "scene/camera_view.h"
#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr int kSize = 64;

/// Of quantities of order one, on 99 % of the pixels away from edges, as for the textured mesh.
constexpr double kTolerance = 2e-3;

struct Case
{
    Scene scene;
    Camera camera;
    Picture picture;
    std::vector<CastPixel> cast;
};

/// Two tori, the second mirrored, double-sided and of another material.
Case makeCase()
{
    Case c;
    c.scene = texturedTorus();
    c.scene.materials.push_back(c.scene.materials[0]);
    c.scene.materials[1].roughnessFactor = 0.5;
    c.scene.materials[1].doubleSided = true;
    Primitive second = c.scene.primitives[0];
    second.material = 1;
    dmat4 m = translation(dvec3(0.4, 1.0, -0.3));
    m[0] = dvec4(-1, 0, 0, 0);
    addInstance(c.scene, second, m);
    c.camera = fitCamera(c.scene, {0.5, 1.1}, 1.0, 0.7, 0.05);
    Settings settings = settingsOf("gltf", kSize);
    settings.layers = true;
    c.picture = draw(c.scene, c.camera, settings);
    c.cast = castPicture(c.scene, plannedMethods(c.scene, settings, 0), c.camera, kSize, kSize);
    return c;
}

const Layer& layerOf(const Picture& picture, std::string_view name)
{
    const auto found =
        std::find_if(picture.layers.begin(), picture.layers.end(), [&](const Layer& l) { return l.name == name; });
    EXPECT_NE(found, picture.layers.end()) << name;
    return found == picture.layers.end() ? picture.layers.front() : *found;
}

dvec3 valueOf(const Layer& layer, int x, int y)
{
    const float* p = layer.image.at(x, y);
    return layer.image.channels == 1 ? dvec3(p[0], 0.0, 0.0) : dvec3(p[0], p[1], p[2]);
}

/// The share of the covered pixels away from edges that lie within the tolerance.
double agreeingShare(const Case& c, std::string_view name, const std::function<dvec3(const CastPixel&)>& exact,
                     double tolerance)
{
    const Layer& layer = layerOf(c.picture, name);
    int agreeing = 0;
    int compared = 0;
    for (std::size_t i = 0; i < c.cast.size(); ++i) {
        if (!c.cast[i].covered || c.cast[i].nearEdge)
            continue;
        const dvec3 drawn = valueOf(layer, static_cast<int>(i) % kSize, static_cast<int>(i) / kSize);
        ++compared;
        agreeing += glm::distance(drawn, exact(c.cast[i])) <= tolerance ? 1 : 0;
    }
    EXPECT_GT(compared, kSize * kSize / 8);
    return static_cast<double>(agreeing) / std::max(compared, 1);
}

TEST(Layers, AreTheSurfaceParametersOfTheirPixels)
{
    const Case c = makeCase();
    const dvec3 eye = cameraPosition(c.camera);
    const dvec3 forward = -dvec3(c.camera.worldFromCamera[2]);
    const std::pair<const char*, std::function<dvec3(const CastPixel&)>> layers[] = {
        {"depth", [&](const CastPixel& p) { return dvec3(glm::dot(p.surface.position, forward), 0, 0); }},
        {"position", [&](const CastPixel& p) { return eye + p.surface.position; }},
        {"normal", [](const CastPixel& p) { return p.material.normal; }},
        {"geometric_normal", [](const CastPixel& p) { return p.surface.geometricNormal; }},
        {"base_color", [](const CastPixel& p) { return p.material.baseColor; }},
        {"metallic", [](const CastPixel& p) { return dvec3(p.material.metallic, 0, 0); }},
        {"roughness", [](const CastPixel& p) { return dvec3(p.material.perceptualRoughness, 0, 0); }},
        {"occlusion", [](const CastPixel& p) { return dvec3(p.material.occlusion, 0, 0); }},
        {"emissive", [](const CastPixel& p) { return p.material.emissive; }},
    };
    for (const auto& [name, exact] : layers)
        EXPECT_GE(agreeingShare(c, name, exact, kTolerance), 0.99) << name;
}

TEST(Layers, IdsNameObjectAndMaterialFromOne)
{
    const Case c = makeCase();
    const auto object = [](const CastPixel& p) { return dvec3(p.surface.object + 1, 0, 0); };
    const auto material = [](const CastPixel& p) { return dvec3(p.surface.material + 1, 0, 0); };
    EXPECT_EQ(agreeingShare(c, "object_id", object, 0.0), 1.0);
    EXPECT_EQ(agreeingShare(c, "material_id", material, 0.0), 1.0);
    EXPECT_EQ(valueOf(layerOf(c.picture, "object_id"), 0, 0).x, 0.0) << "nothing is there";
}

// `torrance reference --aov` has the same pictures, from rays.
TEST(Layers, AreTheReferencesToo)
{
    const Case c = makeCase();
    const std::vector<Layer> exact =
        splitLayers(surfaceTargets(c.scene, c.camera, kSize, kSize), cameraPosition(c.camera));
    ASSERT_EQ(exact.size(), c.picture.layers.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const auto at = [&](const CastPixel& p) {
            const auto index = static_cast<int>(&p - c.cast.data());
            return valueOf(exact[i], index % kSize, index / kSize);
        };
        EXPECT_EQ(exact[i].name, c.picture.layers[i].name);
        EXPECT_GE(agreeingShare(c, exact[i].name, at, kTolerance), 0.99) << exact[i].name;
    }
}

} // namespace
} // namespace torrance::test
