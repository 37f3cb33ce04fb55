// Scenes from files: glTF 2.0, as .gltf or .glb, and OBJ with MTL.
#pragma once

#include "scene/known_image.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace torrance {

/// What one file may ask for. Its counts are compared with these before anything is allocated for them: one accessor
/// can be read by any number of primitives, and a few bytes can state any count.
struct SceneLimits
{
    std::size_t vertices = std::size_t(1) << 26;       // in all primitives together: about 4 GB with every attribute
    std::size_t indices = std::size_t(1) << 28;        // 1 GB
    std::size_t instances = std::size_t(1) << 22;      // 0.6 GB of transforms
    std::uint64_t texelBytes = std::uint64_t(4) << 30; // decoded images, counted at eight bytes a texel
};

struct LoadOptions
{
    std::optional<int> scene = {}; // instead of the file's default
    bool allowExternal = false;    // URIs may leave the folder of the file: `..`, absolute paths, file:
    SceneLimits limits = {};

    /// Of a glTF file that is read from a copy: its own path, which messages name and relative URIs start from.
    std::filesystem::path readAs = {};
    /// Asked before each picture is read and decoded: loading ends with Cancelled (core/cancelled.h).
    std::stop_token stop = {};
    /// Of a glTF file: a picture that this knows is not decoded, and has no texels in the scene. Whoever gives it can
    /// do without them.
    KnownImages known = {};
};

/// How many of a kind a file holds, and their names ("" where one has none).
struct NamedItems
{
    std::vector<std::string> names;

    std::size_t count() const { return names.size(); }
};

struct ExtensionFact
{
    std::string name;
    bool required = false;
    bool supported = false;
};

/// What a file holds, for `inspect`.
struct SceneFacts
{
    std::string container; // "GLB", "glTF", "OBJ" or "primitive"
    std::string version;   // empty where the format has none
    std::string generator;
    std::string copyright;
    std::uint64_t fileBytes = 0;
    std::uint64_t bufferBytes = 0; // of all buffers that are used, the GLB's own and others

    std::vector<ExtensionFact> extensions; // by name
    NamedItems scenes, nodes, meshes, materials, textures, images, cameras, lights, skins, animations;
    std::size_t primitives = 0;
    std::size_t accessors = 0;
    std::size_t morphTargets = 0;

    // Of the scene that is drawn, every instance counted.
    int scene = 0; // -1 where the file has none and all its nodes are drawn
    std::size_t instances = 0;
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t lines = 0;
    std::size_t points = 0;
    std::uint64_t texelBytes = 0;    // decoded
    std::size_t replacedNumbers = 0; // NaN and Inf among the numbers that were read
};

/// Which item of a glTF document each item of the scene was read from: loading leaves out what is not drawn, and reads
/// a primitive once for every pose. Empty for other files.
struct FileItems
{
    struct MeshPrimitive
    {
        int mesh = 0;
        int primitive = 0; // of the mesh
        bool operator==(const MeshPrimitive&) const = default;
    };
    std::vector<MeshPrimitive> primitives;  // of Scene::primitives
    std::vector<int> materials;             // of Scene::materials
    std::vector<std::array<int, 2>> uvSets; // of Scene::materials: the sets TEXCOORD_n that its uvSet 0 and 1 are
    std::vector<int> textures;              // of Scene::textures
    std::vector<int> images;                // of Scene::images
};

struct LoadedScene
{
    Scene scene;
    FileItems items;
    SceneFacts facts;
    std::vector<std::string> warnings; // each a line that names the file
    /// Of the encoded bytes, by Scene::images; empty unless LoadOptions::known was asked.
    std::vector<ContentHash> encodedImages = {};
};

/// Reads a scene as it stands at rest: morph targets at their default weights, skins in the pose of the nodes,
/// animations left out with a warning. Only what the scene draws is in it: materials, textures and images that no
/// primitive uses are not decoded. Errors (input) name file, item and remedy, for everything that a damaged or hostile
/// file can hold; a scene number that the file does not have is an Error (usage).
LoadedScene loadScene(const std::filesystem::path& path, const LoadOptions& options = {});

/// What a file holds, without reading geometry or images: also of one that needs an extension that is not supported.
/// The numbers of what is drawn stay zero.
SceneFacts readFacts(const std::filesystem::path& path, const LoadOptions& options = {});

/// What a scene that comes from no file holds: its name, its primitives, what is drawn.
SceneFacts factsOfScene(const Scene& scene);

} // namespace torrance
