// The sphere set: a picture of spheres, a column per roughness and a row per reflectance, on which shading methods are
// judged. Seen along -Z by an orthographic camera, so that a pixel's normal is known and n.v is its z.
#pragma once

#include "plan/method_table.h"
#include "plan/settings.h"
#include "scene/scene.h"

#include <optional>

namespace torrance {

inline constexpr int kSphereCell = 24;   // pixels along the side of a sphere's square
inline constexpr int kSphereRadius = 11; // pixels
/// Pixels nearer to the silhouette do not count: there the rounding of the place is most of the normal.
inline constexpr double kLeastSphereCosine = 0.05;

/// Roughnesses from nearly a mirror to all, a dielectric and three grey metals.
MethodGrid sphereGrid();

struct SpherePixel
{
    std::size_t reflectance = 0, roughness = 0, column = 0; // of the grid
    dvec3 normal = dvec3(0.0, 0.0, 1.0);
};

/// The surface under the centre of a pixel; nothing between the spheres and at their silhouettes.
std::optional<SpherePixel> spherePixel(const MethodGrid& grid, int x, int y);
/// Scene::materials of a sphere set.
std::size_t sphereMaterial(const MethodGrid& grid, const SpherePixel& pixel);

enum class SphereBodies
{
    colored,
    black, // dielectrics without their diffuse part: what is left is the interface
};

/// Analytic spheres without light.
Scene sphereSet(const MethodGrid& grid, SphereBodies bodies);
/// The same as meshes under a normal map that is finer than the picture's pixels.
Scene bumpySphereSet(const MethodGrid& grid);
/// The bumps themselves, for a scene with texture coordinates: its material 0 gets them.
void addBumps(Scene& scene);

Camera sphereCamera(const MethodGrid& grid);
/// Of one sphere's square, of kSphereCell pixels a side: an analytic shape is a triangle over the whole picture, and
/// each is drawn in a picture of its own.
Camera cellCamera(const MethodGrid& grid, int column, int row);
/// One sample a pixel, nothing behind.
Settings sphereSettings(const MethodGrid& grid, const brdf::Preset& methods);

/// Directional lights all round, some of them grazing and from behind.
std::vector<Light> sphereLamps();
/// Two lights with a radius before the set.
std::vector<Light> sphereAreaLights();

} // namespace torrance
