#include "reference/pixel_condition.h"

#include "reference/analytic_shape.h"
#include "scene/camera_view.h"

#include <functional>
#include <limits>

namespace torrance {
namespace {

/// Moves one input by `step` of its size.
using Move = std::function<void(PixelInputs&, double step)>;

/// A vector's components, one at a time, by its length.
template <typename Select>
void addVector(std::vector<Move>& moves, Select select)
{
    for (int c = 0; c < 3; ++c)
        moves.push_back([=](PixelInputs& inputs, double step) {
            auto& v = select(inputs);
            v[c] += step * glm::length(dvec3(v));
        });
}

template <typename Select>
void addNumber(std::vector<Move>& moves, Select select)
{
    moves.push_back([=](PixelInputs& inputs, double step) { select(inputs) *= 1.0 + step; });
}

void addLight(std::vector<Move>& moves, std::size_t i, Light::Kind kind)
{
    if (kind != Light::Kind::point)
        addVector(moves, [=](PixelInputs& p) -> dvec3& { return p.lights[i].direction; });
    if (kind == Light::Kind::directional)
        return;
    addVector(moves, [=](PixelInputs& p) -> dvec3& { return p.lights[i].position; });
    addNumber(moves, [=](PixelInputs& p) -> double& { return p.lights[i].range; });
    if (kind != Light::Kind::spot)
        return;
    addNumber(moves, [=](PixelInputs& p) -> double& { return p.lights[i].innerConeAngle; });
    addNumber(moves, [=](PixelInputs& p) -> double& { return p.lights[i].outerConeAngle; });
}

std::vector<Move> allMoves(const PixelInputs& inputs)
{
    std::vector<Move> moves;
    addVector(moves, [](PixelInputs& p) -> dvec3& { return p.ray.direction; });
    for (int column = 0; column < 4; ++column)
        addVector(moves, [=](PixelInputs& p) -> dvec4& { return p.shape.worldFromObject[column]; });
    addNumber(moves, [](PixelInputs& p) -> double& { return p.material.roughnessFactor; });
    for (std::size_t i = 0; i < inputs.lights.size(); ++i)
        addLight(moves, i, inputs.lights[i].kind);
    return moves;
}

PixelInputs moved(const PixelInputs& inputs, const Move& move, double step)
{
    PixelInputs result = inputs;
    move(result, step);
    return result;
}

constexpr double kSteps[] = {-kInputRounding, kInputRounding};

Ray unitRay(const PixelInputs& inputs)
{
    return {inputs.ray.origin, glm::normalize(inputs.ray.direction)};
}

std::optional<ShapeHit> meet(const PixelInputs& inputs)
{
    return intersectShape(inputs.shape, dvec3(0.0), unitRay(inputs),
                          inputs.material.doubleSided ? Sides::both : Sides::front);
}

MaterialPoint materialPointOf(const Material& material, const ShapeHit& met, const Ray& ray)
{
    Scene scene;
    scene.materials.push_back(material);
    SurfacePoint surface;
    surface.material = 0;
    surface.view = -ray.direction;
    surface.normal = met.normal;
    surface.front = glm::dot(met.normal, ray.direction) < 0.0;
    return makeMaterialPoint(scene, surface);
}

} // namespace

PixelInputs pixelInputs(const Scene& scene, int shape, const Camera& camera, int width, int height, int x, int y)
{
    const dvec3 eye = cameraPosition(camera);
    PixelInputs inputs;
    inputs.ray = primaryRay(camera, width, height, x + 0.5, y + 0.5);
    inputs.shape = scene.shapes[static_cast<std::size_t>(shape)];
    inputs.shape.worldFromObject[3] -= dvec4(eye, 0.0);
    inputs.material = materialOf(scene, inputs.shape.material);
    inputs.lights = scene.lights;
    for (Light& light : inputs.lights)
        light.position -= eye;
    if (scene.environment)
        inputs.uniformRadiance = uniformRadiance(*scene.environment).value_or(dvec3(0.0));
    return inputs;
}

std::optional<PixelSurface> pixelSurface(const PixelInputs& inputs)
{
    const Ray ray = unitRay(inputs);
    const std::optional<ShapeHit> met = meet(inputs);
    if (!met)
        return std::nullopt;
    return PixelSurface{materialPointOf(inputs.material, *met, ray), met->position, -ray.direction};
}

std::optional<dvec3> pixelRadiance(const brdf::Preset& preset, const PixelInputs& inputs)
{
    const std::optional<PixelSurface> surface = pixelSurface(inputs);
    if (!surface)
        return std::nullopt;
    const Illumination illumination{inputs.lights, inputs.uniformRadiance};
    return shade(preset, illumination, surface->material, dvec3(0.0), surface->position, surface->view);
}

bool coverageIsDecided(const PixelInputs& inputs)
{
    const bool covered = meet(inputs).has_value();
    for (const Move& move : allMoves(inputs))
        for (const double step : kSteps)
            if (meet(moved(inputs, move, step)).has_value() != covered)
                return false;
    return true;
}

dvec3 pixelCondition(const PixelFormula& formula, const PixelInputs& inputs)
{
    if (!coverageIsDecided(inputs))
        return dvec3(std::numeric_limits<double>::infinity());
    const dvec3 here = formula(inputs).value_or(dvec3(0.0));
    dvec3 sum(0.0);
    for (const Move& move : allMoves(inputs)) {
        dvec3 change(0.0);
        for (const double step : kSteps)
            change = glm::max(change, glm::abs(formula(moved(inputs, move, step)).value_or(dvec3(0.0)) - here));
        sum += change;
    }
    return sum;
}

dvec3 pixelCondition(const brdf::Preset& preset, const PixelInputs& inputs)
{
    return pixelCondition([&](const PixelInputs& p) { return pixelRadiance(preset, p); }, inputs);
}

} // namespace torrance
