#include "make_assets/surface.h"

#include <algorithm>
#include <utility>

namespace torrance::assets {
namespace {

// Central differences in double: the error of a second-order step of 1e-5 is near 1e-10, far below float's.
constexpr double kStep = 1e-5;
// How far inside a pole its normal is taken, in parameter space: far less than a grid cell.
constexpr double kInside = 1e-4;

vec2 chartCoordinates(const Chart& chart, int atlasSize, double u, double v)
{
    return vec2((chart.x + 0.5 + u * (chart.width - 1)) / atlasSize,
                (chart.y + 0.5 + v * (chart.height - 1)) / atlasSize);
}

void appendTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    const auto& p = mesh.positions;
    if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a])
        return;
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

} // namespace

std::vector<double> evenSteps(int n)
{
    std::vector<double> steps;
    for (int i = 0; i <= n; ++i)
        steps.push_back(static_cast<double>(i) / n);
    return steps;
}

void appendSurface(Mesh& mesh, const Surface& surface, const Chart& chart, int atlasSize)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const double v : surface.vs)
        for (const double u : surface.us) {
            const SurfacePoint point = surface.at(u, v);
            mesh.positions.emplace_back(point.position);
            mesh.normals.emplace_back(point.normal);
            mesh.tangents.emplace_back(vec3(point.tangent), 1.0f);
            mesh.uvs.emplace_back(point.uv);
            mesh.charts.push_back(chartCoordinates(chart, atlasSize, u, v));
        }
    const auto columns = static_cast<std::uint32_t>(surface.us.size());
    const auto rows = static_cast<std::uint32_t>(surface.vs.size());
    for (std::uint32_t row = 0; row + 1 < rows; ++row)
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t a = first + row * columns + column;
            appendTriangle(mesh, a, a + columns, a + columns + 1);
            appendTriangle(mesh, a, a + columns + 1, a + 1);
        }
}

Surface surfaceFromPositions(std::function<dvec3(double u, double v)> position, int columns, int rows)
{
    const auto at = [position = std::move(position)](double u, double v) {
        const double vInside = std::clamp(v, kInside, 1.0 - kInside);
        const dvec3 du = position(u + kStep, vInside) - position(u - kStep, vInside);
        const dvec3 dv = position(u, vInside + kStep) - position(u, vInside - kStep);
        return SurfacePoint{position(u, v), glm::normalize(glm::cross(dv, du)), glm::normalize(du), dvec2(u, v)};
    };
    return {at, evenSteps(columns), evenSteps(rows)};
}

} // namespace torrance::assets
