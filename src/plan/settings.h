// What is asked of a picture, beyond the scene itself.
#pragma once

#include "brdf/method.h"
#include "math/vector.h"
#include "plan/light_methods.h"
#include "plan/view.h"

#include <map>
#include <optional>

namespace torrance {

enum class BackgroundKind
{
    environment, // the panorama; black where the scene has none
    color,
    transparent, // alpha 0, colours premultiplied
};

/// How opaque and masked surfaces come to their light.
enum class RenderPath
{
    forward,    // each surface is shaded as it is drawn
    prepass,    // depth first, then only what is seen is shaded: the picture of `forward`, to the bit
    attributes, // what is interpolated first, as bits; then each pixel is shaded once
    deferred,   // parameters first, into a G-buffer of floats; light afterwards, once a pixel
};

struct Settings
{
    brdf::Preset methods;
    int width = 1024;
    int height = 1024;
    int samples = 1;             // per pixel
    int environmentSamples = 64; // per pixel and picture, of methods of environmentSpecular that draw samples
    int lightSamples = 64;       // per pixel, picture and light with a radius, of the method `sampled` of areaLight
    /// By number in Scene::materials, the one behind the last being glTF's default material: surfaces that compute
    /// light otherwise than `methods` and the numbers above say.
    std::map<int, LightMethods> ofMaterials = {};
    BackgroundKind background = BackgroundKind::environment;
    dvec3 backgroundColor = dvec3(0.0); // scene-linear
    double backgroundBlur = 0.0; // of BackgroundKind::environment: the perceptual roughness (0 to 1) of the GGX kernel
                                 // of N = V = R that it is seen through
    std::optional<RenderPath> path = {}; // none: the plan chooses
    /// Of triangles that show at no pixel's centre, on the processor: the same picture. None: where it pays.
    std::optional<bool> triangleCulling = {};
    const View* view = nullptr; // a term instead of the colour; null: the colour
    int viewLight = 0;          // of ShadingPlan::lights
    bool layers = false;        // surface parameters as pictures of their own
};

} // namespace torrance
