#include "study/analytic_scenes.h"

namespace torrance {

Material plainMaterial(const dvec3& baseColor, double metallic, double perceptualRoughness)
{
    Material material;
    material.baseColorFactor = dvec4(baseColor, 1.0);
    material.metallicFactor = metallic;
    material.roughnessFactor = perceptualRoughness;
    return material;
}

Scene shapeScene(AnalyticShape::Kind kind, const Material& material)
{
    Scene scene;
    scene.materials.push_back(material);
    AnalyticShape shape;
    shape.kind = kind;
    shape.material = 0;
    const dvec3 z =
        glm::normalize(dvec3(0.3, 0.35, 0.9)); // about half way between testLight and the camera of the tests
    const dvec3 x = glm::normalize(glm::cross(dvec3(0.1, 1.0, 0.2), z));
    shape.worldFromObject = dmat4(dmat3(x, glm::cross(z, x), z) * 0.8);
    shape.worldFromObject[3] = dvec4(kShapeCenter, 1.0);
    scene.shapes.push_back(shape);
    return scene;
}

Light testLight(Light::Kind kind)
{
    Light light;
    light.kind = kind;
    light.color = dvec3(1.0, 0.8, 0.6);
    light.position = dvec3(1.1, 0.9, 2.4);
    light.direction = glm::normalize(kShapeCenter + dvec3(0.2, 0.1, 0.0) - light.position);
    light.intensity = kind == Light::Kind::directional ? 3.0 : 12.0;
    light.range = kind == Light::Kind::point ? 5.0 : 0.0;
    light.innerConeAngle = 0.1;
    light.outerConeAngle = 0.3;
    return light;
}

Environment uniformEnvironment(const dvec3& radiance)
{
    Environment environment;
    environment.name = "uniform";
    environment.radiance = Image(16, 8, 3);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 3; ++c)
                environment.radiance.at(x, y)[c] = static_cast<float>(radiance[c]);
    return environment;
}

} // namespace torrance
