// A surface of a path, and the random numbers that are spent at it.
#pragma once

#include "math/frame.h"
#include "math/number_stream.h"
#include "math/scrambled_sequence.h"
#include "reference/bounce_directions.h"
#include "reference/off_surface.h"
#include "reference/reflectance.h"

#include <array>

namespace torrance {

/// What one surface of a path is drawn with, all in [0, 1).
struct PathNumbers
{
    dvec2 bounce, environment, emitter, sphere;
    double whichEmitter, whichSphere, whichPoint;
    std::uint64_t walk; // of yardsticks that are random themselves

    /// Of a surface that the eye sees: points that are even over the paths of one sum, each kind of its own sequence.
    /// What is added up from one sequence must not be paired with another's, for these are scrambled, not shuffled.
    PathNumbers(const std::array<ScrambledSequence, 4>& sequences, std::uint32_t i, NumberStream& stream)
        : PathNumbers(stream)
    {
        bounce = sequences[0][i];
        environment = sequences[1][i];
        emitter = sequences[2][i];
        sphere = sequences[3][i];
    }

    /// Of every other surface.
    explicit PathNumbers(NumberStream& stream)
        : bounce(pair(stream)), environment(pair(stream)), emitter(pair(stream)), sphere(pair(stream)),
          whichEmitter(stream.next()), whichSphere(stream.next()), whichPoint(stream.next()),
          walk(static_cast<std::uint64_t>(stream.next() * 0x1p52))
    {
    }

    static dvec2 pair(NumberStream& stream)
    {
        const double x = stream.next(); // of two arguments nobody says which is evaluated first
        return {x, stream.next()};
    }
};

/// A surface of a path, ready to be asked what it does with light.
struct PathVertex
{
    const SurfacePoint& surface;
    const MaterialPoint& material;
    dmat3 worldFromLocal; // local: the shading normal is +Z
    dvec3 view;           // local
    Reflectance reflectance;
    BounceDirections directions;
    dvec3 start; // of rays that leave it

    PathVertex(const Yardstick& yardstick, const dvec3& origin, const SurfacePoint& s, const MaterialPoint& m)
        : surface(s), material(m), worldFromLocal(frameAround(m.normal)), view(s.view * worldFromLocal),
          reflectance(yardstick, m, view, ResponsePart::whole, true), directions(m, view),
          start(offSurface(origin, s.position, s.geometricNormal))
    {
    }

    /// Light from below the shading horizon has no reflection, and light from below the surface does not arrive.
    bool faces(const dvec3& direction) const
    {
        return glm::dot(direction, material.normal) > 0.0 && glm::dot(direction, surface.geometricNormal) > 0.0;
    }
};

} // namespace torrance
