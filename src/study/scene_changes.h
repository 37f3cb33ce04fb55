// Changes of a scene whose effect on the picture is known beforehand.
#pragma once

#include "scene/scene.h"

namespace torrance {

/// What is drawn, and from where.
struct Subject
{
    Scene scene;
    Camera camera;
};

/// All lengths times `factor`, and the candela of point and spot lights times its square: the picture stays.
Subject scaled(Subject subject, double factor);

/// Everything moved: the picture stays.
Subject translated(Subject subject, const dvec3& offset);

/// The camera turned so that what it sees moves by a part of a pixel; a perspective or orthographic picture of `height`
/// pixels.
Camera shiftedByPixels(Camera camera, const dvec2& pixels, int height, double distance);

/// Every texture mirrored from left to right and every coordinate with it, tangents and normal maps too: the picture
/// stays. False where a picture serves as a normal map and as something else, which cannot be mirrored for both.
bool mirrorUvs(Scene& scene);

/// One coordinate everywhere: triangles without area in the map.
void collapseUvs(Scene& scene);

/// A normal map, in place of each that there is and for every material with coordinates, whose normal is 45 degrees
/// below the surface.
void turnNormalsBelow(Scene& scene);

void setRoughness(Scene& scene, double perceptualRoughness);
/// Of every material; its texture goes.
void setMetallic(Scene& scene, double metallic);
/// Of every material that is not unlit: a black body without emission, and an interface of this index over it.
void leaveInterface(Scene& scene, double ior);
/// Of every material with an occlusion texture. False where there is none.
bool setOcclusionStrength(Scene& scene, double strength);
/// The material's occlusion textures go.
void removeOcclusion(Scene& scene);

/// A panorama of even radiance with one texel that is `texel` times brighter.
Environment environmentWithSpot(double radiance, double texel);

} // namespace torrance
