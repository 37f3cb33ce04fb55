#include "plan/level_plan.h"

#include "plan/pixel_sampling_plan.h"
#include "scene/camera_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torrance {
namespace {

/// A device takes the level from differences between neighbouring pixels and an approximate logarithm: lavapipe's is
/// off by up to 0.043, and differences across an edge reach a pixel beyond the triangle.
constexpr double kLevelMargin = 0.25;
/// Triangles, each in each of its places, that are worth asking: a millisecond or two.
constexpr double kMostTriangles = 200000.0;

/// How large a pixel is on a surface that is seen from the front.
class PixelFootprint
{
public:
    PixelFootprint(const Camera& c, int width, int height) : camera(c), view(viewFromWorld(c)), eye(cameraPosition(c))
    {
        const dmat4 projection = projectionMatrix(c, static_cast<double>(width) / height);
        const dvec2 half = {1.0 / std::abs(projection[0][0]), 1.0 / std::abs(projection[1][1])}; // at depth 1
        pixel = 2.0 * std::min(half.x / width, half.y / height);
        // A ray at an angle to the axis moves by 1 / cos less of what it moves along a plane across the axis.
        if (isPerspective())
            pixel /= std::sqrt(1.0 + glm::dot(half, half));
    }

    bool isPerspective() const { return camera.kind == Camera::Kind::perspective; }

    /// Along the axis, from the eye.
    double depthOf(const dvec3& world) const { return -(view * dvec4(world - eye, 0.0)).z; }

    /// The least length on a surface that one pixel's step can be, where no point of it is nearer than `depth`.
    double leastStep(double depth) const { return isPerspective() ? pixel * std::max(depth, camera.nearPlane) : pixel; }

private:
    const Camera& camera;
    dmat4 view;
    dvec3 eye;
    double pixel;
};

/// The length (Frobenius) of the map from metres of the triangle's plane to `uv`, scaled to texels. 0: all of the
/// triangle lies at one place of the texture, or it has no plane.
double texelsPerMetre(const std::array<dvec3, 3>& p, const std::array<dvec2, 3>& texel)
{
    const dvec3 a = p[1] - p[0], b = p[2] - p[0];
    const dvec2 da = texel[1] - texel[0], db = texel[2] - texel[0];
    const double length = glm::length(a);
    if (length == 0.0)
        return 0.0;
    const dvec3 x = a / length; // axes of the plane: a = (length, 0), b = (along, across)
    const double along = glm::dot(b, x), across = glm::length(b - along * x);
    if (across == 0.0)
        return 0.0;
    const dvec2 dx = da / length, dy = (db - along * dx) / across;
    return std::sqrt(glm::dot(dx, dx) + glm::dot(dy, dy));
}

class LevelPlanner
{
public:
    LevelPlanner(const Scene& s, const ShadingPlan& p, const Camera& camera)
        : scene(s), plan(p), footprint(camera, p.settings.width, p.settings.height),
          least(p.textures.size(), std::numeric_limits<double>::infinity())
    {
    }

    std::vector<int> run()
    {
        if (triangles() > kMostTriangles)
            return std::vector<int>(plan.textures.size(), 0);
        for (const auto* list : {&plan.batches, &plan.blended})
            for (const Batch& batch : *list)
                for (const Draw& draw : batch.draws)
                    for (std::size_t role = 0; role < kTextureRoles; ++role)
                        if (const int texture = batch.textures[role]; texture >= 0)
                            visit(draw, static_cast<TextureRole>(role), static_cast<std::size_t>(texture));
        std::vector<int> levels;
        for (std::size_t i = 0; i < least.size(); ++i)
            levels.push_back(levelOf(i));
        return levels;
    }

private:
    double triangles() const
    {
        double count = 0.0;
        for (const auto* list : {&plan.batches, &plan.blended})
            for (const Batch& batch : *list)
                for (const Draw& draw : batch.draws)
                    count += triangleCount(scene, draw);
        return count;
    }

    const Primitive& primitiveOf(const Draw& draw) const
    {
        return scene.primitives[static_cast<std::size_t>(draw.primitive)];
    }

    void visit(const Draw& draw, TextureRole role, std::size_t texture)
    {
        if (least[texture] == 0.0)
            return;
        if (draw.primitive < 0 || primitiveOf(draw).topology != Topology::triangles) {
            least[texture] = 0.0; // a line has no footprint
            return;
        }
        const int material = plan.blocks[static_cast<std::size_t>(draw.block)].material;
        const TextureUse& use = useOf(plan.materials[static_cast<std::size_t>(material)].material, role);
        for (int i = 0; i < draw.instanceCount; ++i)
            visitInstance(primitiveOf(draw),
                          plan.instances[static_cast<std::size_t>(draw.firstInstance + i)].worldFromObject, use,
                          texture);
    }

    void visitInstance(const Primitive& primitive, const dmat4& worldFromObject, const TextureUse& use,
                       std::size_t texture)
    {
        const std::vector<vec2>& uvs = primitive.uvs[static_cast<std::size_t>(use.uvSet)];
        const dvec2 size(plan.textures[texture].width, plan.textures[texture].height);
        for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
            std::array<dvec3, 3> p;
            std::array<dvec2, 3> texel;
            double depth = std::numeric_limits<double>::infinity(), farthest = -depth;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t index = primitive.indices[i + k];
                p[k] = dvec3(worldFromObject * dvec4(dvec3(primitive.positions[index]), 1.0));
                texel[k] = size * (use.transform * dvec3(dvec2(uvs[index]), 1.0));
                depth = std::min(depth, footprint.depthOf(p[k]));
                farthest = std::max(farthest, footprint.depthOf(p[k]));
            }
            if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0] || (footprint.isPerspective() && farthest <= 0.0))
                continue; // covers no pixel
            // The longer of two steps is at least the root of their mean square, and no step is shorter than leastStep.
            const double step = texelsPerMetre(p, texel) * footprint.leastStep(depth) / std::sqrt(2.0);
            least[texture] = std::min(least[texture], step);
        }
    }

    int levelOf(std::size_t texture) const
    {
        const PlannedTexture& planned = plan.textures[texture];
        if (planned.sampler.mip == MipFilter::none || !(least[texture] > 0.0) || std::isinf(least[texture]))
            return 0;
        const double level = std::floor(std::log2(least[texture]) + levelBias(plan.settings) - kLevelMargin);
        int finest = 0;
        while (finest < level && planned.width % (2 << finest) == 0 && planned.height % (2 << finest) == 0)
            ++finest;
        return finest;
    }

    const Scene& scene;
    const ShadingPlan& plan;
    PixelFootprint footprint;
    std::vector<double> least; // by texture: texels that a pixel's longer step covers
};

} // namespace

double levelBias(const Settings& settings)
{
    return -0.5 * std::log2(static_cast<double>(pictureCount(settings)));
}

std::vector<int> finestLevels(const Scene& scene, const ShadingPlan& plan, const Camera& camera)
{
    return LevelPlanner(scene, plan, camera).run();
}

} // namespace torrance
