// Scenes for image tests, made in memory. Lengths in metres.
#pragma once

#include "study/analytic_scenes.h"

#include <functional>

namespace torrance::test {

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

/// The demo scene in the light of the studio.
Scene demoScene();

/// A white square without light whose right half is masked away, for maskedHalfCamera and a picture of `size` pixels:
/// the border lies `place` pixels into the column size / 2, of the texture and not of a triangle.
Scene maskedHalf(int size, double place);
/// Without perspective; the square fills the picture but for `place`.
Camera maskedHalfCamera();

/// Radiance that is bright on one side, of all bands, without an edge.
dvec3 glow(const dvec3& direction);

dmat4 translation(const dvec3& offset);

} // namespace torrance::test
