#include "reference/path_tracer.h"

#include "reference/emission.h"
#include "reference/path_vertex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torrance {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double brightest(const dvec3& color)
{
    return std::max({color.r, color.g, color.b});
}

/// Distance from `position` to where a ray meets the sphere of a light: from outside its near side, from inside the far
/// one.
double distanceToSphere(const Light& light, const dvec3& origin, const dvec3& position, const dvec3& direction)
{
    const dvec3 toCentre = light.position - origin - position;
    const double along = glm::dot(toCentre, direction);
    const dvec3 across = toCentre - along * direction;
    const double half = std::sqrt(std::max(0.0, light.radius * light.radius - glm::dot(across, across)));
    return glm::dot(toCentre, toCentre) > light.radius * light.radius ? along - half : along + half;
}

/// The number of an item drawn by its share; shares add up to 1.
std::size_t chosen(const std::vector<double>& shares, double u)
{
    std::size_t last = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (!(shares[i] > 0.0))
            continue;
        last = i;
        if (u < shares[i])
            return i;
        u -= shares[i];
    }
    return last; // rounding
}

} // namespace

PathTracer::PathTracer(const RayCaster& caster, const Yardstick& y, const EnvironmentSampler* e, DirectionChoice c)
    : rays(caster), yardstick(y), environment(e), choice(c), emitters(caster)
{
    for (const Light& light : caster.scene().lights)
        (isSphere(light) ? spheres : points).push_back(light);
}

double PathTracer::weightOfBounce(double bounce, double light) const
{
    switch (choice) {
    case DirectionChoice::brdf:
        return 1.0;
    case DirectionChoice::light:
        return light > 0.0 ? 0.0 : 1.0;
    case DirectionChoice::combined:
        break;
    }
    return bounce / (bounce + light);
}

/// f L NoL over the density of the light's own draws and, where both are made, that of the path's.
dvec3 PathTracer::contribution(const PathVertex& vertex, const dvec3& direction, const DirectedLight& light,
                               std::uint64_t key) const
{
    if (!vertex.faces(direction) || !(light.density > 0.0) || light.radiance == dvec3(0.0))
        return dvec3(0.0);
    const dvec3 l = direction * vertex.worldFromLocal;
    const double bounce = choice == DirectionChoice::combined ? vertex.directions.density(l) : 0.0;
    return vertex.reflectance(l, key) * light.radiance / (light.density + bounce);
}

dvec3 PathTracer::drawnEnvironment(const PathVertex& vertex, const PathNumbers& numbers) const
{
    const dvec3 direction = environment->draw(numbers.environment);
    const dvec3 light = contribution(vertex, direction, environment->at(direction), numbers.walk);
    return light == dvec3(0.0) ? light : light * rays.transmittance(vertex.start, direction, kInfinity);
}

dvec3 PathTracer::drawnEmitter(const PathVertex& vertex, const PathNumbers& numbers) const
{
    const auto sample = emitters.draw(vertex.surface.position, numbers.whichEmitter, numbers.emitter);
    if (!sample)
        return dvec3(0.0);
    const dvec3 light = contribution(vertex, sample->direction, sample->light, numbers.walk + 1);
    if (light == dvec3(0.0))
        return light;
    const dvec3 way = sample->target - vertex.start;
    const double distance = glm::length(way);
    return distance > 0.0 ? light * rays.transmittance(vertex.start, way / distance, distance) : light;
}

std::vector<double> PathTracer::sharesOf(const PathVertex& vertex, const std::vector<Light>& lights) const
{
    std::vector<double> shares(lights.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < lights.size(); ++i)
        sum += shares[i] = brightest(sampleLight(lights[i], rays.caster.origin(), vertex.surface.position).irradiance);
    for (double& share : shares)
        share = sum > 0.0 ? share / sum : 0.0;
    return shares;
}

dvec3 PathTracer::drawnSphere(const PathVertex& vertex, const PathNumbers& numbers) const
{
    const std::vector<double> shares = sharesOf(vertex, spheres);
    const std::size_t i = chosen(shares, numbers.whichSphere);
    const SphereLight sphere(spheres[i], rays.caster.origin(), vertex.surface.position);
    const dvec3 direction = sphere.draw(numbers.sphere);
    DirectedLight drawn = sphere.at(direction);
    drawn.density *= shares[i];
    const dvec3 light = contribution(vertex, direction, drawn, numbers.walk + 2);
    if (light == dvec3(0.0))
        return light;
    return light *
           rays.transmittance(vertex.start, direction,
                              distanceToSphere(spheres[i], rays.caster.origin(), vertex.surface.position, direction));
}

dvec3 PathTracer::spheresMet(const PathVertex& vertex, const Bounce& bounce, double farthest) const
{
    const std::vector<double> shares = sharesOf(vertex, spheres);
    dvec3 sum(0.0);
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const dvec3& position = vertex.surface.position;
        const DirectedLight light = SphereLight(spheres[i], rays.caster.origin(), position).at(bounce.direction);
        if (light.radiance != dvec3(0.0) &&
            distanceToSphere(spheres[i], rays.caster.origin(), position, bounce.direction) < farthest)
            sum += light.radiance * weightOfBounce(bounce.density, shares[i] * light.density);
    }
    return sum;
}

dvec3 PathTracer::pointLight(const PathVertex& vertex, const Light& light) const
{
    const LightSample sample = sampleLight(light, rays.caster.origin(), vertex.surface.position);
    if (sample.irradiance == dvec3(0.0) || !vertex.faces(sample.direction))
        return dvec3(0.0);
    const double distance = light.kind == Light::Kind::directional
                                ? kInfinity
                                : glm::length(light.position - rays.caster.origin() - vertex.surface.position);
    return sample.irradiance * rays.transmittance(vertex.start, sample.direction, distance);
}

dvec3 PathTracer::drawnPoint(const PathVertex& vertex, const PathNumbers& numbers) const
{
    const std::vector<double> shares = sharesOf(vertex, points);
    const std::size_t i = chosen(shares, numbers.whichPoint);
    if (!(shares[i] > 0.0))
        return dvec3(0.0);
    const dvec3 irradiance = pointLight(vertex, points[i]) / shares[i];
    if (irradiance == dvec3(0.0))
        return irradiance;
    const dvec3 direction = sampleLight(points[i], rays.caster.origin(), vertex.surface.position).direction;
    return irradiance * vertex.reflectance(direction * vertex.worldFromLocal, numbers.walk + 3);
}

dvec3 PathTracer::exactLight(const VisibleSurface& seen) const
{
    dvec3 light = emittedRadiance(rays.caster.scene(), seen.surface, seen.material);
    if (seen.material.unlit || std::holds_alternative<const InterfaceAlbedo*>(yardstick))
        return light;
    const PathVertex vertex(yardstick, rays.caster.origin(), seen.surface, seen.material);
    for (const Light& point : points)
        if (const dvec3 irradiance = pointLight(vertex, point); irradiance != dvec3(0.0)) {
            const dvec3 direction = sampleLight(point, rays.caster.origin(), seen.surface.position).direction;
            light += irradiance * vertex.reflectance(direction * vertex.worldFromLocal, 0);
        }
    return light;
}

dvec3 PathTracer::lightAt(const PathVertex& vertex, const PathNumbers& numbers, bool byEye) const
{
    dvec3 light(0.0);
    const bool exact = byEye && std::holds_alternative<const brdf::Preset*>(yardstick); // in exactLight already
    if (!points.empty() && !exact)
        light += drawnPoint(vertex, numbers);
    if (choice == DirectionChoice::brdf)
        return light;
    if (environment)
        light += drawnEnvironment(vertex, numbers);
    if (!emitters.dark())
        light += drawnEmitter(vertex, numbers);
    if (!spheres.empty())
        light += drawnSphere(vertex, numbers);
    return light;
}

dvec3 PathTracer::path(const VisibleSurface& seen, const PathNumbers& first, NumberStream& stream) const
{
    dvec3 light(0.0), share(1.0); // what a surface sends out counts by the share
    PathSurface met = {{}, seen.surface, seen.material};
    PathNumbers numbers = first;
    for (int surfaces = 1;; ++surfaces) {
        const PathVertex vertex(yardstick, rays.caster.origin(), met.surface, met.material);
        light += share * lightAt(vertex, numbers, surfaces == 1);
        const dvec3 l = vertex.directions.draw(numbers.bounce);
        const Bounce bounce = {vertex.worldFromLocal * l, vertex.directions.density(l)};
        if (!(l.z > 0.0) || !vertex.faces(bounce.direction) || !(bounce.density > 0.0))
            return light;
        share *= vertex.reflectance(l, numbers.walk + 4) / bounce.density;
        if (share == dvec3(0.0))
            return light;
        std::optional<PathSurface> next = rays.next({vertex.start, bounce.direction}, stream);
        if (!spheres.empty())
            light += share * spheresMet(vertex, bounce, next ? next->hit.distance : kInfinity);
        if (!next) {
            if (environment) {
                const DirectedLight far = environment->at(bounce.direction);
                light += share * far.radiance * weightOfBounce(bounce.density, far.density);
            }
            return light;
        }
        const dvec3 emitted = emittedRadiance(rays.caster.scene(), next->surface, next->material);
        if (emitted != dvec3(0.0))
            light += share * emitted * weightOfBounce(bounce.density, emitters.density(next->hit, next->surface));
        if (next->material.unlit)
            return light;
        if (surfaces >= kSureSurfaces) {
            const double survival = std::min(kMostSurvival, brightest(share));
            if (!(stream.next() < survival))
                return light;
            share /= survival;
        }
        met = *next;
        numbers = PathNumbers(stream);
    }
}

dvec3 PathTracer::sumOfTurns(const VisibleSurface& seen, std::uint64_t key, std::uint32_t first,
                             std::uint32_t turns) const
{
    const std::array<ScrambledSequence, 4> sequences = {
        ScrambledSequence(hashNumbers({key, 0})), ScrambledSequence(hashNumbers({key, 1})),
        ScrambledSequence(hashNumbers({key, 2})), ScrambledSequence(hashNumbers({key, 3}))};
    dvec3 sum(0.0);
    for (std::uint32_t i = first * kDirectionsPerTurn; i < (first + turns) * kDirectionsPerTurn; ++i) {
        NumberStream stream(hashNumbers({key, 4, i}));
        const PathNumbers numbers(sequences, i, stream);
        sum += path(seen, numbers, stream);
    }
    return sum;
}

} // namespace torrance
