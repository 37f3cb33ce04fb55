// What will be computed for a scene, as plain data with a reason for every choice. A pure function of scene (texels
// included) and settings: it can be printed and tested without a device.
#pragma once

#include "math/box.h"
#include "plan/material_plan.h"
#include "plan/remark.h"
#include "plan/settings.h"
#include "plan/shader_key.h"
#include "plan/texture_plan.h"
#include "scene/scene.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace torrance {

/// Neighbouring instances of one primitive, or one analytic shape.
struct Draw
{
    int primitive = -1;    // Scene::primitives, or
    int shape = -1;        // Scene::shapes
    int firstInstance = 0; // ShadingPlan::instances
    int instanceCount = 1;
    bool mirrored = false; // the transforms turn the winding round
    int block = 0;         // ShadingPlan::blocks
    int uvSet = 0;         // of a key whose textures are read at one place: the coordinates that place is made from
    bool starBody = false; // its back is never seen from outside of it
    bool culls = false;    // on the processor, before it is drawn: culling_plan.h
    Box bounds;            // of all instances, world
};

/// A material as the shaders of some draws read it.
struct MaterialBlock
{
    int material = 0; // ShadingPlan::materials
    int slot = 0;     // of the attributes path: its number in its class
    TextureSet textures = kNoTextures;
};

/// Surfaces that the attributes path shades in one go: one shader, one set of textures.
struct ShadingClass
{
    ShaderKey key; // of what is left of the surfaces' keys: attribute_plan.h
    TextureSet textures = kNoTextures;
    std::vector<int> blocks; // ShadingPlan::blocks by slot
};

/// Draws of one shader and one set of textures.
struct Batch
{
    ShaderKey key;
    TextureSet textures = kNoTextures;
    std::vector<Draw> draws;
    int shadingClass = -1; // ShadingPlan::classes; -1: its surfaces are shaded as they are drawn
};

/// An instance in the order in which the device sees it.
struct PlannedInstance
{
    int material = 0; // ShadingPlan::materials
    int object = 0;   // for object-id pictures
    dmat4 worldFromObject = dmat4(1.0);
    dvec3 center = dvec3(0.0); // of the bounds, world: blended surfaces are sorted by it
};

struct ShadingPlan
{
    Settings settings;
    /// How light is computed, by ShaderKey::choice: the settings of a picture of these surfaces alone. At least one.
    std::vector<Settings> choices;
    RenderPath path = RenderPath::forward;
    std::vector<PlannedMaterial> materials; // Scene::materials, and glTF's default material last
    std::vector<PlannedTexture> textures;
    std::vector<MaterialBlock> blocks;
    std::vector<PlannedInstance> instances;
    std::vector<Batch> batches; // opaque and masked
    std::vector<Batch> blended; // one draw of one instance each
    std::vector<Light> lights;  // directional, then point, then spot
    std::array<int, 3> lightCounts = {0, 0, 0};
    bool areaLights = false;                // some light has a radius, and some surface sees it
    bool environmentLight = false;          // some surface is lit by the environment
    bool panorama = false;                  // the environment is seen behind the scene
    bool dfgTable = false;                  // some shader reads directional albedos
    std::vector<ShadingClass> classes;      // of the attributes path
    std::vector<ShaderKey> lightingClasses; // of the deferred path, one lighting pass each: deferred_plan.h
    Remarks remarks;
};

/// Throws Error (usage) where methods are combined that no table was made for.
ShadingPlan makePlan(const Scene& scene, const Settings& settings);
/// The same, of a scene whose texels are known: nothing asks for them.
ShadingPlan makePlan(const Scene& scene, std::span<const TexelFacts> facts, const Settings& settings);

/// Of all instances; 0 for an analytic shape.
double triangleCount(const Scene& scene, const Draw& draw);

/// The settings by which surfaces of this key are lit.
const Settings& choiceOf(const ShadingPlan& plan, const ShaderKey& key);

/// Whether the environment's part of these methods needs a table of directional albedos: that of the slot dfg, or
/// source B's map.
bool environmentReadsTable(const brdf::Preset& methods);

/// Whether lights with a radius are drawn as such.
bool drawsAreaLights(const brdf::Preset& methods);

/// Whether a punctual light's part needs the table of directional albedos.
bool readsAlbedo(const brdf::Preset& methods, bool compensates);

/// The text of selected.glsl for one key: methods and defines.
std::string selectedText(const ShadingPlan& plan, const ShaderKey& key);

/// The same for the two shaders of the attributes path: of a batch that leaves attributes, of a class that reads them.
std::string attributesText(const ShadingPlan& plan, const Batch& batch);
std::string resolveText(const ShadingPlan& plan, const ShadingClass& shadingClass);

/// The plan for people: methods, what stands, what was left out and why, the pipelines it takes.
std::string explain(const ShadingPlan& plan);

} // namespace torrance
