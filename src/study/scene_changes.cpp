#include "study/scene_changes.h"

#include "scene/tangents.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace torrance {
namespace {

void scaleTranslation(dmat4& matrix, double factor)
{
    matrix[3] = dvec4(dvec3(matrix[3]) * factor, 1.0);
}

// The whole transform, so that shapes and meshes grow.
dmat4 grown(const dmat4& worldFromObject, double factor)
{
    dmat4 scale(factor);
    scale[3][3] = 1.0;
    return scale * worldFromObject;
}

template <typename Change>
void forEachTextureUse(Scene& scene, const Change& change)
{
    for (Material& material : scene.materials)
        for (TextureUse* use : {&material.baseColor, &material.metallicRoughness, &material.normal, &material.occlusion,
                                &material.emissive})
            if (use->used())
                change(*use, use == &material.normal);
}

// F T F, F: u -> 1 - u. uv' = T uv becomes F uv' = (F T F) (F uv).
glm::dmat3x2 mirroredTransform(const glm::dmat3x2& t)
{
    return {t[0].x, -t[0].y, -t[1].x, t[1].y, 1.0 - t[0].x - t[2].x, t[0].y + t[2].y};
}

void mirrorRow(std::byte* row, int width, std::size_t texel)
{
    std::vector<std::byte> swapped(texel);
    for (int x = 0; x < width / 2; ++x) {
        std::byte* left = row + static_cast<std::size_t>(x) * texel;
        std::byte* right = row + static_cast<std::size_t>(width - 1 - x) * texel;
        std::memcpy(swapped.data(), left, texel);
        std::memcpy(left, right, texel);
        std::memcpy(right, swapped.data(), texel);
    }
}

// The first channel, x of a normal map: code c stands for 2 c / most - 1, and most - c for its negative.
void negateX(TextureImage& image)
{
    const std::size_t texel = bytesPerTexel(image.format);
    for (std::size_t at = 0; at < image.texels.size(); at += texel)
        for (std::size_t byte = 0; byte < texel / 4; ++byte)
            image.texels[at + byte] = ~image.texels[at + byte];
}

void mirrorImage(TextureImage& image, bool normalMap)
{
    const std::size_t texel = bytesPerTexel(image.format);
    for (int y = 0; y < image.height; ++y)
        mirrorRow(image.texels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) * texel,
                  image.width, texel);
    if (normalMap)
        negateX(image);
}

} // namespace

Subject scaled(Subject subject, double factor)
{
    for (Instance& instance : subject.scene.instances)
        instance.worldFromObject = grown(instance.worldFromObject, factor);
    for (AnalyticShape& shape : subject.scene.shapes)
        shape.worldFromObject = grown(shape.worldFromObject, factor);
    for (Light& light : subject.scene.lights) {
        light.position *= factor;
        light.range *= factor;
        light.radius *= factor;
        if (light.kind != Light::Kind::directional)
            light.intensity *= factor * factor;
    }
    Camera& camera = subject.camera;
    scaleTranslation(camera.worldFromCamera, factor);
    for (double* length : {&camera.xmag, &camera.ymag, &camera.nearPlane, &camera.farPlane})
        *length *= factor;
    return subject;
}

Subject translated(Subject subject, const dvec3& offset)
{
    for (Instance& instance : subject.scene.instances)
        instance.worldFromObject[3] += dvec4(offset, 0.0);
    for (AnalyticShape& shape : subject.scene.shapes)
        shape.worldFromObject[3] += dvec4(offset, 0.0);
    for (Light& light : subject.scene.lights)
        light.position += offset;
    subject.camera.worldFromCamera[3] += dvec4(offset, 0.0);
    return subject;
}

Camera shiftedByPixels(Camera camera, const dvec2& pixels, int height, double distance)
{
    const double pixel = camera.kind == Camera::Kind::orthographic
                             ? 2.0 * camera.ymag / height
                             : 2.0 * distance * std::tan(0.5 * camera.verticalFov) / height;
    const dvec3 right = dvec3(camera.worldFromCamera[0]), up = dvec3(camera.worldFromCamera[1]);
    camera.worldFromCamera[3] += dvec4(pixel * (pixels.x * right - pixels.y * up), 0.0);
    return camera;
}

bool mirrorUvs(Scene& scene)
{
    std::set<int> normalMaps, others;
    forEachTextureUse(scene, [&](TextureUse& use, bool normal) {
        (normal ? normalMaps : others).insert(scene.textures[static_cast<std::size_t>(use.texture)].image);
        use.transform = mirroredTransform(use.transform);
    });
    for (const int image : normalMaps)
        if (others.contains(image))
            return false;
    for (std::size_t i = 0; i < scene.images.size(); ++i)
        mirrorImage(scene.images[i], normalMaps.contains(static_cast<int>(i)));
    for (Primitive& primitive : scene.primitives) {
        for (auto& set : primitive.uvs)
            for (vec2& uv : set)
                uv.x = 1.0f - uv.x;
        for (vec4& tangent : primitive.tangents)
            tangent = -tangent; // along falling u, and the bitangent stays
    }
    return true;
}

void collapseUvs(Scene& scene)
{
    for (Primitive& primitive : scene.primitives)
        for (auto& set : primitive.uvs)
            std::ranges::fill(set, vec2(0.5f));
}

void turnNormalsBelow(Scene& scene)
{
    // x = 0.7, z = -0.7: 2 c / 255 - 1
    TextureImage below = {.name = "below", .width = 1, .height = 1, .format = TexelFormat::rgba8, .texels = {}};
    for (const int code : {217, 128, 38, 255})
        below.texels.push_back(static_cast<std::byte>(code));
    scene.images.push_back(std::move(below));
    Texture texture;
    texture.image = static_cast<int>(scene.images.size()) - 1;
    scene.textures.push_back(texture);
    for (Material& material : scene.materials) {
        material.normal = {};
        material.normal.texture = static_cast<int>(scene.textures.size()) - 1;
    }
    for (Primitive& primitive : scene.primitives)
        if (primitive.topology == Topology::triangles && primitive.tangents.empty() && !primitive.normals.empty() &&
            !primitive.uvs[0].empty())
            primitive = makeTangents(primitive, 0, TextureUse().transform);
}

void setRoughness(Scene& scene, double perceptualRoughness)
{
    for (Material& material : scene.materials)
        material.roughnessFactor = perceptualRoughness; // 0 is 0 whatever the texture says
}

void setMetallic(Scene& scene, double metallic)
{
    for (Material& material : scene.materials) {
        material.metallicFactor = metallic;
        material.metallicRoughness.texture = -1;
    }
}

void leaveInterface(Scene& scene, double ior)
{
    setMetallic(scene, 0.0);
    for (Material& material : scene.materials) {
        material.baseColorFactor = dvec4(0.0, 0.0, 0.0, material.baseColorFactor.w);
        material.emissiveFactor = dvec3(0.0);
        material.ior = ior;
    }
}

bool setOcclusionStrength(Scene& scene, double strength)
{
    bool any = false;
    for (Material& material : scene.materials)
        if (material.occlusion.used()) {
            material.occlusionStrength = strength;
            any = true;
        }
    return any;
}

void removeOcclusion(Scene& scene)
{
    for (Material& material : scene.materials)
        material.occlusion.texture = -1;
}

Environment environmentWithSpot(double radiance, double texel)
{
    Environment environment;
    environment.name = "spot";
    environment.radiance = Image(64, 32, 3, static_cast<float>(radiance));
    for (int channel = 0; channel < 3; ++channel)
        environment.radiance.at(40, 8)[channel] = static_cast<float>(radiance * texel);
    return environment;
}

} // namespace torrance
