#include "make_assets/demo_materials.h"

namespace torrance::assets {
namespace {

// Measured reflectance of metals at normal incidence, linear sRGB: Hoffman 2010, "Background: Physics and Math of
// Shading".
const dvec4 kGold(1.022, 0.782, 0.344, 1.0);
const dvec4 kCopper(0.955, 0.638, 0.538, 1.0);
const dvec4 kSteel(0.562, 0.565, 0.578, 1.0);
const dvec4 kBrass(0.887, 0.722, 0.434, 1.0);

DemoMaterial plain(const std::string& name, const dvec4& color, double metallic, double roughness)
{
    DemoMaterial material;
    material.name = name;
    material.baseColor = color;
    material.metallic = metallic;
    material.roughness = roughness;
    return material;
}

DemoMaterial clockFace()
{
    DemoMaterial material = plain("clock face", dvec4(0.012, 0.012, 0.014, 1.0), 0.0, 0.12);
    material.emissive = dvec3(1.0, 0.36, 0.10);
    material.emissiveStrength = 4.0;
    material.emissivePicture = {.file = "numerals.png"};
    return material;
}

DemoMaterial brassScreen()
{
    DemoMaterial material = plain("perforated brass", kBrass, 1.0, 0.28);
    material.baseColorPicture = {.file = "perforated.png", .repeat = dvec2(34.0, 8.5)};
    material.alphaMode = "MASK";
    material.doubleSided = true;
    return material;
}

DemoMaterial lamp()
{
    DemoMaterial material = plain("lamp", dvec4(0.9, 0.85, 0.75, 1.0), 0.0, 0.6);
    material.emissive = dvec3(1.0, 0.62, 0.28);
    material.emissiveStrength = 3.2;
    return material;
}

DemoMaterial leafMaterial()
{
    DemoMaterial material = plain("leaf", dvec4(1.0), 0.0, 0.55);
    material.baseColorPicture = {.file = "leaf.png"};
    material.alphaMode = "MASK";
    material.doubleSided = true;
    return material;
}

DemoMaterial amberGlass()
{
    DemoMaterial material = plain("amber glass", dvec4(0.80, 0.20, 0.015, 0.55), 0.0, 0.04);
    material.alphaMode = "BLEND";
    return material;
}

DemoMaterial textured(DemoMaterial material, const PictureUse& color, const PictureUse& roughness)
{
    material.baseColorPicture = color;
    material.roughnessPicture = roughness;
    return material;
}

DemoMaterial hammered(DemoMaterial material)
{
    material.normalPicture = {.file = "hammered_normal.png", .repeat = dvec2(2.0, 1.0)};
    material.normalScale = 0.7;
    return material;
}

} // namespace

std::vector<DemoMaterial> demoMaterials()
{
    // In the order of Finish.
    return {
        plain("paper", dvec4(0.47, 0.53, 0.52, 1.0), 0.0, 0.95),
        textured(plain("terrazzo", dvec4(1.0), 0.0, 0.32),
                 {.file = "terrazzo.png", .repeat = dvec2(2.0), .rotation = 0.4}, {}),
        textured(plain("glaze", dvec4(1.0), 0.0, 0.10), {.file = "glaze.png"}, {}),
        textured(plain("walnut", dvec4(1.0), 0.0, 1.0), {.file = "wood.png", .repeat = dvec2(1.4)},
                 {.file = "wood_roughness.png", .repeat = dvec2(1.4)}),
        plain("polished gold", glm::min(kGold, dvec4(1.0)), 1.0, 0.09),
        hammered(plain("hammered copper", kCopper, 1.0, 0.20)),
        textured(plain("brushed steel", kSteel, 1.0, 1.0), {},
                 {.file = "brushed_roughness.png", .repeat = dvec2(2.0, 1.0)}),
        plain("coral plastic", dvec4(0.80, 0.16, 0.09, 1.0), 0.0, 0.30),
        plain("ivory ceramic", dvec4(0.83, 0.79, 0.70, 1.0), 0.0, 0.16),
        plain("chrome", dvec4(0.55, 0.556, 0.554, 1.0), 1.0, 0.03),
        clockFace(),
        brassScreen(),
        plain("brass", kBrass, 1.0, 0.22),
        lamp(),
        leafMaterial(),
        plain("bark", dvec4(0.16, 0.11, 0.07, 1.0), 0.0, 0.8),
        amberGlass(),
    };
}

} // namespace torrance::assets
