#include "scene/scene_hash.h"

namespace torrance {
namespace {

template <typename T>
requires std::is_arithmetic_v<T> || std::is_enum_v<T>
void add(ContentHasher& hasher, const T& value)
{
    hasher.add(value);
}

void add(ContentHasher& hasher, const std::string& text)
{
    hasher.add(std::string_view(text));
}

template <glm::length_t N, typename T>
void add(ContentHasher& hasher, const glm::vec<N, T>& vector)
{
    hasher.add(std::as_bytes(std::span(&vector, 1)));
}

template <glm::length_t C, glm::length_t R, typename T>
void add(ContentHasher& hasher, const glm::mat<C, R, T>& matrix)
{
    hasher.add(std::as_bytes(std::span(&matrix, 1)));
}

// Numbers, and vectors of them, without padding: as one block.
template <typename T>
concept Block = std::is_arithmetic_v<T> || std::is_same_v<T, std::byte> || std::is_same_v<T, vec2> ||
    std::is_same_v<T, vec3> || std::is_same_v<T, vec4>;

template <Block T>
void add(ContentHasher& hasher, const std::vector<T>& items)
{
    hasher.add(std::as_bytes(std::span(items)));
}

template <typename... Members>
void addAll(ContentHasher& hasher, const Members&... members);

// The names of all members are spelt out in what follows, so that a new one does not compile until it is hashed.

void add(ContentHasher& hasher, const TextureUse& use)
{
    const auto& [texture, uvSet, transform] = use;
    addAll(hasher, texture, uvSet, transform);
}

void add(ContentHasher& hasher, const Image& image)
{
    const auto& [width, height, channels, texels] = image;
    addAll(hasher, width, height, channels, texels);
}

void add(ContentHasher& hasher, const Material& material)
{
    const auto& [name, baseColorFactor, baseColor, metallicFactor, roughnessFactor, metallicRoughness, normalScale,
                 normal, occlusionStrength, occlusion, emissiveFactor, emissive, alphaMode, alphaCutoff, doubleSided,
                 unlit, ior] = material;
    addAll(hasher, name, baseColorFactor, baseColor, metallicFactor, roughnessFactor, metallicRoughness, normalScale,
           normal, occlusionStrength, occlusion, emissiveFactor, emissive, alphaMode, alphaCutoff, doubleSided, unlit,
           ior);
}

void add(ContentHasher& hasher, const Texture& texture)
{
    const auto& [image, sampler] = texture;
    const auto& [wrapS, wrapT, magnify, minify, mip] = sampler;
    addAll(hasher, image, wrapS, wrapT, magnify, minify, mip);
}

void add(ContentHasher& hasher, const TextureImage& image)
{
    const auto& [name, width, height, format, texels] = image;
    addAll(hasher, name, width, height, format, texels);
}

void add(ContentHasher& hasher, const Primitive& primitive)
{
    const auto& [name, topology, positions, normals, tangents, uvs, colors, indices, material, boundsMin, boundsMax] =
        primitive;
    addAll(hasher, name, topology, positions, normals, tangents, uvs[0], uvs[1], colors, indices, material, boundsMin,
           boundsMax);
}

void add(ContentHasher& hasher, const Instance& instance)
{
    const auto& [primitive, object, worldFromObject] = instance;
    addAll(hasher, primitive, object, worldFromObject);
}

void add(ContentHasher& hasher, const AnalyticShape& shape)
{
    const auto& [kind, material, worldFromObject, name] = shape;
    addAll(hasher, kind, material, worldFromObject, name);
}

void add(ContentHasher& hasher, const Light& light)
{
    const auto& [name, kind, color, intensity, range, radius, innerConeAngle, outerConeAngle, position, direction] =
        light;
    addAll(hasher, name, kind, color, intensity, range, radius, innerConeAngle, outerConeAngle, position, direction);
}

void add(ContentHasher& hasher, const Camera& camera)
{
    const auto& [name, kind, worldFromCamera, verticalFov, aspect, xmag, ymag, nearPlane, farPlane] = camera;
    addAll(hasher, name, kind, worldFromCamera, verticalFov, aspect, xmag, ymag, nearPlane, farPlane);
}

void add(ContentHasher& hasher, const Environment& environment)
{
    const auto& [name, radiance, rotation, intensity] = environment;
    (void)name; // where it came from
    addAll(hasher, radiance, rotation, intensity);
}

template <typename T>
requires(!Block<T>) void add(ContentHasher& hasher, const std::vector<T>& items)
{
    hasher.add(items.size());
    for (const T& item : items)
        add(hasher, item);
}

template <typename T>
void add(ContentHasher& hasher, const std::optional<T>& item)
{
    hasher.add(item.has_value());
    if (item)
        add(hasher, *item);
}

template <typename... Members>
void addAll(ContentHasher& hasher, const Members&... members)
{
    (add(hasher, members), ...);
}

} // namespace

void addToHash(ContentHasher& hasher, const Scene& scene)
{
    const auto& [name, primitives, instances, shapes, materials, textures, images, lights, cameras, environment] =
        scene;
    (void)name; // where it came from
    addAll(hasher, primitives, instances, shapes, materials, textures, images, lights, cameras, environment);
}

void addToHash(ContentHasher& hasher, const Camera& camera)
{
    add(hasher, camera);
}

} // namespace torrance
