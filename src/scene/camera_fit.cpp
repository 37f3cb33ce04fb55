#include "scene/camera_fit.h"

#include "scene/camera_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torrance {
namespace {

/// What must be inside the picture: points (radius 0) and balls.
struct Ball
{
    dvec3 center;
    double radius;
};

bool isFinite(const dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Largest distance from the centre of a ball under a matrix that may scale: an upper bound that is exact for the
/// similarity transforms that AnalyticShape asks for.
double scaleOf(const dmat4& m)
{
    return std::max({glm::length(dvec3(m[0])), glm::length(dvec3(m[1])), glm::length(dvec3(m[2]))});
}

void appendShape(const AnalyticShape& shape, std::vector<Ball>& balls)
{
    if (shape.kind == AnalyticShape::Kind::sphere) {
        balls.push_back({dvec3(shape.worldFromObject[3]), scaleOf(shape.worldFromObject)});
        return;
    }
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            balls.push_back({dvec3(shape.worldFromObject * dvec4(x, y, 0.0, 1.0)), 0.0});
}

/// The vertices that some index names: files often share one long accessor between many primitives.
void appendInstance(const Primitive& primitive, const dmat4& worldFromObject, std::vector<Ball>& balls)
{
    std::vector<bool> named(primitive.positions.size(), false);
    for (const std::uint32_t i : primitive.indices)
        named[i] = true;
    for (std::size_t i = 0; i < named.size(); ++i)
        if (named[i])
            balls.push_back({dvec3(worldFromObject * dvec4(dvec3(primitive.positions[i]), 1.0)), 0.0});
}

std::vector<Ball> sceneBalls(const Scene& scene)
{
    std::vector<Ball> balls;
    for (const Instance& i : scene.instances)
        appendInstance(scene.primitives[static_cast<std::size_t>(i.primitive)], i.worldFromObject, balls);
    for (const AnalyticShape& shape : scene.shapes)
        appendShape(shape, balls);
    std::erase_if(balls, [](const Ball& b) { return !isFinite(b.center) || !std::isfinite(b.radius); });
    return balls;
}

Bounds boundsOf(const std::vector<Ball>& balls)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Bounds bounds{dvec3(kInfinity), dvec3(-kInfinity), balls.empty()};
    for (const Ball& b : balls) {
        bounds.min = glm::min(bounds.min, b.center - b.radius);
        bounds.max = glm::max(bounds.max, b.center + b.radius);
    }
    return bounds.empty ? Bounds{} : bounds;
}

/// The highest support of the balls by lines of slope t: max of side * x + t * z, and the z where it is reached.
struct Support
{
    double value = -std::numeric_limits<double>::infinity();
    double z = 0.0;
};

/// `axis` is 0 for the width and 1 for the height; `side` is +1 or -1. A ball reaches r sqrt(1 + t^2) beyond its
/// centre.
Support support(const std::vector<Ball>& balls, int axis, double side, double t)
{
    Support best;
    const double secant = std::sqrt(1.0 + t * t);
    for (const Ball& b : balls) {
        const double value = side * b.center[axis] + t * b.center.z + b.radius * secant;
        if (value > best.value)
            best = {value, b.center.z + b.radius * t / secant};
    }
    return best;
}

/// The eye's depth at which both sides touch. Inside means side * (x - eye.x) <= t (eye.z - z) for both sides: the two
/// inequalities added leave 2 t eye.z >= A + B with A, B the supports.
double fittingDepth(const std::vector<Ball>& balls, int axis, double t)
{
    return (support(balls, axis, 1.0, t).value + support(balls, axis, -1.0, t).value) / (2.0 * t);
}

/// The eye's place across the view that centres the projection, for an eye at this depth. It is where the half width t
/// of the projection is smallest: the root of g(t) = 2 t depth - A(t) - B(t), concave because A and B are convex, so
/// that Newton's steps from t = 0 climb to it and never pass it; for points alone they end after finitely many.
double centringPlace(const std::vector<Ball>& balls, int axis, double depth)
{
    constexpr int kMostSteps = 64; // each step is a different pair of vertices; 3 to 8 are usual
    double t = 0.0;
    Support a;
    Support b;
    for (int step = 0; step < kMostSteps; ++step) {
        a = support(balls, axis, 1.0, t);
        b = support(balls, axis, -1.0, t);
        const double slope = 2.0 * depth - a.z - b.z;
        const double next = t + (a.value + b.value - 2.0 * t * depth) / slope;
        if (!(next > t * (1.0 + 4.0 * std::numeric_limits<double>::epsilon())))
            break;
        t = next;
    }
    return 0.5 * (a.value - b.value);
}

/// The shortest rotation that brings +Y to `up`.
dmat3 worldFromOrbit(const dvec3& up)
{
    const double length = glm::length(up);
    if (!(length > 0.0) || !std::isfinite(length))
        return dmat3(1.0);
    const dvec3 u = up / length;
    constexpr double kOpposite = 1e-12; // 1 + cos below which the axis of the turn is rounding: up = -Y
    if (1.0 + u.y < kOpposite)
        return dmat3(dvec3(-1, 0, 0), dvec3(0, -1, 0), dvec3(0, 0, 1));
    const double k = 1.0 / (1.0 + u.y); // Rodrigues' formula for the axis (u.z, 0, -u.x)
    return dmat3(dvec3(1.0 - k * u.x * u.x, -u.x, -k * u.x * u.z), u, dvec3(-k * u.x * u.z, -u.z, 1.0 - k * u.z * u.z));
}

/// Camera axes in the world: right, up, backwards (from the target to the eye).
dmat3 orbitAxes(const OrbitAngles& angles)
{
    const double st = std::sin(angles.theta);
    const double ct = std::cos(angles.theta);
    const double sp = std::sin(angles.phi);
    const double cp = std::cos(angles.phi);
    return worldFromOrbit(angles.up) *
           dmat3(dvec3(ct, 0.0, -st), dvec3(-cp * st, sp, -cp * ct), dvec3(sp * st, cp, sp * ct));
}

Camera cameraAt(const dmat3& axes, const dvec3& position, double verticalFov)
{
    Camera camera;
    camera.worldFromCamera = dmat4(axes);
    camera.worldFromCamera[3] = dvec4(position, 1.0);
    camera.verticalFov = verticalFov;
    return camera;
}

/// The balls in the camera's axes about `origin`, with something of extent in them.
std::vector<Ball> ballsInView(std::vector<Ball> balls, const Bounds& bounds, const dmat3& axes, const dvec3& origin)
{
    const double magnitude = bounds.empty ? 0.0 : glm::length(origin);
    constexpr double kNoExtent = 1e-12; // of the distance from the world's origin: double itself holds no more
    if (bounds.empty || glm::length(bounds.max - bounds.min) <= kNoExtent * magnitude)
        return {{dvec3(0.0), std::max(kPointExtent, kNoExtent * magnitude)}};
    const dmat3 viewFromWorldAxes = glm::transpose(axes);
    for (Ball& b : balls)
        b.center = viewFromWorldAxes * (b.center - origin);
    return balls;
}

} // namespace

Bounds worldBounds(const Scene& scene)
{
    return boundsOf(sceneBalls(scene));
}

Camera orbitCamera(const OrbitAngles& angles, double radius, const dvec3& target, double verticalFov)
{
    const dmat3 axes = orbitAxes(angles);
    return cameraAt(axes, target + radius * axes[2], verticalFov);
}

Camera lookAtCamera(const dvec3& position, const dvec3& target, const dvec3& up, double verticalFov)
{
    const auto unitOr = [](const dvec3& v, const dvec3& fallback) {
        const double length = glm::length(v);
        return length > 0.0 && std::isfinite(length) ? v / length : fallback;
    };
    const dvec3 back = unitOr(position - target, dvec3(0, 0, 1));
    const dvec3 wanted = unitOr(up, dvec3(0, 1, 0));
    constexpr double kParallel = 1e-6; // sine of the angle below which `up` says nothing about the roll
    const dvec3 sideways = glm::cross(wanted, back);
    const dvec3 spare = std::abs(back.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(0, 0, -back.y);
    const dvec3 right = glm::normalize(glm::length(sideways) > kParallel ? sideways : glm::cross(spare, back));
    return cameraAt(dmat3(right, glm::cross(back, right), back), position, verticalFov);
}

Camera fitCamera(const Scene& scene, const OrbitAngles& angles, double aspect, double verticalFov, double margin)
{
    const dmat3 axes = orbitAxes(angles);
    std::vector<Ball> balls = sceneBalls(scene);
    const Bounds bounds = boundsOf(balls);
    const dvec3 origin = 0.5 * (bounds.min + bounds.max);
    balls = ballsInView(std::move(balls), bounds, axes, origin);

    const double tangentY = std::tan(0.5 * verticalFov) * (1.0 - margin);
    const double tangentX = tangentY * aspect;
    const Bounds inView = boundsOf(balls);
    const double diagonal = glm::length(bounds.max - bounds.min);
    const double depth = std::max({fittingDepth(balls, 0, tangentX), fittingDepth(balls, 1, tangentY),
                                   inView.max.z + kLeastClearance * diagonal});
    const dvec3 eye(centringPlace(balls, 0, depth), centringPlace(balls, 1, depth), depth);
    Camera camera = cameraAt(axes, origin + axes * eye, verticalFov);
    camera.nearPlane = 0.5 * (depth - inView.max.z);
    return camera;
}

Camera fitNearPlane(const Camera& camera, const Scene& scene)
{
    const Bounds bounds = worldBounds(scene);
    const double diagonal = bounds.empty ? kPointExtent : glm::length(bounds.max - bounds.min);
    const dvec3 forward = -dvec3(glm::transpose(dmat3(viewFromWorld(camera)))[2]);
    double closest = std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8 && !bounds.empty; ++corner) {
        const dvec3 p((corner & 1) != 0 ? bounds.max.x : bounds.min.x, (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                      (corner & 4) != 0 ? bounds.max.z : bounds.min.z);
        closest = std::min(closest, glm::dot(p - cameraPosition(camera), forward));
    }
    const double least = kLeastNear * (diagonal > 0.0 ? diagonal : kPointExtent);
    Camera result = camera;
    result.nearPlane = bounds.empty ? least : std::max(0.5 * closest, least);
    if (camera.farPlane > 0.0)
        result.nearPlane = std::min(result.nearPlane, 0.5 * camera.farPlane);
    return result;
}

} // namespace torrance
