// Scenes for image tests, made in memory. Lengths in metres.
#pragma once

#include "scene/scene.h"

#include <functional>

namespace torrance::test {

/// A material of factors alone.
Material plainMaterial(const dvec3& baseColor, double metallic, double perceptualRoughness);

/// One analytic shape, turned and off the world's origin, so that no coordinate is zero by chance. A sphere of radius
/// 0.8 or a square of half side 0.8, about (0.3, -0.2, 0.5).
Scene shapeScene(AnalyticShape::Kind kind, const Material& material);

/// One light of each kind that lights shapeScene from the upper right, near enough that its distance matters; the point
/// light has a range, the spot's cone edge crosses the shape.
Light testLight(Light::Kind kind);

/// Every texel the same.
Environment uniformEnvironment(const dvec3& radiance);

/// `width` x `height` texels of `format` from a function of the texel's indices; values in [0, 1] are rounded to code
/// values.
TextureImage makeTexels(int width, int height, TexelFormat format, const std::function<dvec4(int, int)>& value);

/// Appends image and texture; the number of the texture.
int addTexture(Scene& scene, TextureImage image, const Sampler& sampler);

/// No mips: level 0, one filter.
Sampler levelZero(Filter filter, Wrap wrap = Wrap::repeat);

/// The square |x|, |y| <= 1 at z = 0, facing +Z, with normals, tangents along +X, and uv (0, 0) at its upper left.
Primitive square(int material);

/// Appends the primitive and one instance of it; the number of the instance.
int addInstance(Scene& scene, Primitive primitive, const dmat4& worldFromObject);

/// A torus about Y of radii 1 and 0.4 whose base colour, metallic-roughness, normal, occlusion and emissive textures
/// vary smoothly, filtered bilinearly at level 0.
Scene texturedTorus();

dmat4 translation(const dvec3& offset);

} // namespace torrance::test
