// The demo scene before it is a file: a still life on a round plinth.
#pragma once

#include "make_assets/surface.h"

#include <string>
#include <vector>

namespace torrance::assets {

/// A picture that a material uses, and how often it repeats over the material's uv: KHR_texture_transform where not 1.
struct PictureUse
{
    std::string file; // empty: none
    dvec2 repeat = dvec2(1.0);
    dvec2 offset = dvec2(0.0);
    double rotation = 0.0; // radians

    bool used() const { return !file.empty(); }
    bool transformed() const { return repeat != dvec2(1.0) || offset != dvec2(0.0) || rotation != 0.0; }
};

/// glTF's metallic-roughness material, with its names. Colours are linear.
struct DemoMaterial
{
    std::string name;
    dvec4 baseColor = dvec4(1.0);
    double metallic = 0.0;
    double roughness = 1.0;
    dvec3 emissive = dvec3(0.0);
    double emissiveStrength = 1.0; // KHR_materials_emissive_strength where not 1
    std::string alphaMode = "OPAQUE";
    bool doubleSided = false;
    PictureUse baseColorPicture;
    PictureUse roughnessPicture;
    PictureUse normalPicture;
    double normalScale = 1.0;
    PictureUse emissivePicture;
};

/// A part of an object: one surface and the size of its chart in the occlusion atlas, in texels.
struct DemoPart
{
    Surface surface;
    int chartWidth = 0;
    int chartHeight = 0;
    int smoothing = 1; // passes over the chart: more where it is wide and its light changes slowly
};

/// One node, one mesh, one primitive.
struct DemoObject
{
    std::string name;
    int material = 0; // DemoScene::materials
    std::vector<DemoPart> parts;
    dvec3 translation = dvec3(0.0);
    double turn = 0.0;       // radians about +Y
    bool castsShadow = true; // see-through things are left out of the baked occlusion
    bool writesTangents = false;
};

struct DemoCamera
{
    dvec3 position;
    dvec3 target;
    double verticalFov; // radians
    double aspect;
};

struct DemoScene
{
    std::vector<DemoMaterial> materials;
    std::vector<DemoObject> objects;
    DemoCamera camera;
};

DemoScene demoScene();

/// Object space to world.
dvec3 placed(const DemoObject& object, const dvec3& position);
dvec3 turned(const DemoObject& object, const dvec3& direction);

} // namespace torrance::assets
