// What a ray meets first: triangle meshes through Embree, analytic shapes exactly.
#pragma once

#include "math/ray.h"
#include "scene/scene.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>

namespace torrance {

struct Hit
{
    int instance = -1;                        // Scene::instances; -1 where an analytic shape was hit
    int shape = -1;                           // Scene::shapes; -1 where a triangle was hit
    int triangle = 0;                         // number of the index triple
    dvec3 barycentric = dvec3(1.0, 0.0, 0.0); // weights of the three vertices, recomputed in double
    double distance = 0.0;                    // along the ray, metres
    bool front = true; // the counter-clockwise side faces the ray (clockwise where the node mirrors)
};

/// Which sides of a surface a ray meets.
enum class Faces
{
    drawn, // back faces of single-sided materials are not there, as they are not drawn
    both,
};

/// Embree begins this share of its place's size before the ray, and what it finds there counts by its distance in
/// double: 2^-24 is what rounding a place to float moves it by, and a surface nearer than that would be stepped over.
inline constexpr double kFloatSlack = 1e-6;

/// Embree works in float. It only decides which triangle is met; where, is computed again in double. Vertices are
/// handed to it relative to `origin` (the camera's position as a rule), so that scenes far from the world's origin lose
/// nothing. Points and lines are not met.
class RayCaster
{
public:
    /// Keeps a reference to the scene. Throws std::runtime_error where Embree cannot build.
    RayCaster(const Scene& scene, const dvec3& origin);
    ~RayCaster();
    RayCaster(RayCaster&&) noexcept;
    RayCaster& operator=(RayCaster&&) noexcept;

    /// Says of a hit whether it counts (alpha masks); must not throw.
    using Accept = std::function<bool(const Hit&)>;

    /// The nearest accepted hit farther than `beyond` along a ray whose origin is relative to `origin`.
    std::optional<Hit> closest(const Ray& ray, double beyond = 0.0, const Accept& accept = {},
                               Faces faces = Faces::drawn) const;

    /// Whether an accepted hit, of either side of a surface, lies between the ray's origin and `farthest` along it.
    bool blocked(const Ray& ray, double farthest, const Accept& accept = {}) const;

    const Scene& scene() const;
    const dvec3& origin() const;

    /// The mesh of an instance. Where its material has a normal map and it brings no tangents, it is a copy with those
    /// of MikkTSpace (glTF 2.0, section 3.7.2.1): the same triangles, but other numbers of vertices.
    const Primitive& meshOf(int instance) const;

private:
    struct State;
    std::unique_ptr<State> state;
};

/// The ray and the plane of a triangle (Moller & Trumbore 1997, in double): barycentric coordinates, distance and side,
/// of any sign and size. None where the ray lies in the plane.
std::optional<Hit> meetTriangle(const std::array<dvec3, 3>& corners, const Ray& ray);

/// The three corners of a triangle of an instance, in the world relative to `origin`.
std::array<dvec3, 3> triangleCorners(const Scene& scene, int instance, int triangle, const dvec3& origin);

/// glTF's default material stands in for -1.
const Material& materialOf(const Scene& scene, int material);

/// Material index (Scene::materials or -1) of what was hit.
int materialIndexOf(const Scene& scene, const Hit& hit);

} // namespace torrance
