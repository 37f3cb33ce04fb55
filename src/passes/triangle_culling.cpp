#include "passes/triangle_culling.h"

#include "core/parallel.h"
#include "scene/visible_triangles.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

namespace torrance {
namespace {

constexpr std::size_t kJobIndices = 3 << 13;  // of one piece of work, and of one draw
constexpr std::size_t kJobVertices = 1 << 14; // the same

VisibleSides sidesOf(const Batch& batch, const Draw& draw, const PixelBox& seen)
{
    if (!hidesBacks(batch, draw, seen))
        return VisibleSides::both;
    return draw.mirrored ? VisibleSides::clockwise : VisibleSides::counterClockwise;
}

template <typename T>
std::span<const T> mappedSpan(const gpu::Buffer& buffer, vk::DeviceSize offset, std::size_t count)
{
    return {reinterpret_cast<const T*>(buffer.mapped + offset), count};
}

} // namespace

bool hidesBacks(const Batch& batch, const Draw& draw, const PixelBox& seen)
{
    return !batch.key.doubleSided || (draw.starBody && !seen.nearCut);
}

// One instance of a draw.
struct TriangleCulling::Work
{
    int draw; // Draw::firstInstance
    std::uint32_t instance;
    std::span<const vec3> positions;
    std::span<const std::uint32_t> indices;
    std::optional<TriangleView> view; // none: all triangles are kept
    std::size_t firstPlace = 0;       // in `places`
    std::size_t firstIndex = 0;       // in the buffer
};

std::vector<TriangleCulling::Work> TriangleCulling::workOf(const DeviceScene& scene, const Camera& camera,
                                                           const shared::Frame& frame,
                                                           std::span<const shared::Instance> instances) const
{
    const ivec2 pixels(scene.plan.settings.width, scene.plan.settings.height);
    std::vector<Work> all;
    for (const Batch& batch : scene.plan.batches)
        for (const Draw& draw : batch.draws) {
            if (!draw.culls)
                continue;
            const PixelBox seen = pixelBoxOf(camera, pixels.x, pixels.y, draw.bounds);
            if (seen.empty())
                continue;
            const PrimitiveRange& range = scene.meshes->ranges[static_cast<std::size_t>(draw.primitive)];
            const Primitive& primitive = scene.scene.primitives[static_cast<std::size_t>(draw.primitive)];
            const Box box = {primitive.boundsMin, primitive.boundsMax};
            const Box uploaded = {box.least - range.center, box.greatest - range.center};
            for (int i = draw.firstInstance; i < draw.firstInstance + draw.instanceCount; ++i) {
                const dmat4& placed = scene.plan.instances[static_cast<std::size_t>(i)].worldFromObject;
                if (pixelBoxOf(camera, pixels.x, pixels.y, transformed(placed, box)).empty())
                    continue;
                const shared::Instance& instance = instances[static_cast<std::size_t>(i)];
                all.push_back(
                    {.draw = draw.firstInstance,
                     .instance = static_cast<std::uint32_t>(i),
                     .positions = mappedSpan<vec3>(scene.meshes->vertices,
                                                   range.streams[static_cast<std::size_t>(VertexAttribute::position)],
                                                   range.vertexCount),
                     .indices = mappedSpan<std::uint32_t>(scene.meshes->indices,
                                                          range.firstIndex * sizeof(std::uint32_t), range.indexCount),
                     .view = triangleView({frame.clipFromEye, instance.linear, instance.translation}, uploaded, pixels,
                                          sidesOf(batch, draw, seen), device.limits.subPixelPrecisionBits)});
            }
        }
    std::size_t placeCount = 0, indexCount = 0;
    for (Work& work : all) {
        work.firstPlace = placeCount;
        work.firstIndex = indexCount;
        placeCount += work.positions.size();
        indexCount += work.indices.size();
    }
    return all;
}

const VisibleTriangles* TriangleCulling::find(const DeviceScene& scene, const Camera& camera,
                                              const shared::Frame& frame, std::span<const shared::Instance> instances)
{
    // On a card, its own triangles are cheap, and its memory is dear to read from here.
    if (!device.description.isProcessor() && scene.plan.settings.triangleCulling != true)
        return nullptr;
    const std::vector<Work> all = workOf(scene, camera, frame, instances);
    visible.draws.clear();
    for (const Batch& batch : scene.plan.batches)
        for (const Draw& draw : batch.draws)
            if (draw.culls)
                visible.draws[draw.firstInstance]; // with no range where nothing of it is seen
    if (visible.draws.empty())
        return nullptr;

    // A piece of one instance: of its vertices, then of its triangles.
    struct Piece
    {
        const Work* work;
        std::size_t first, count;
        std::size_t kept = 0; // indices
    };
    std::vector<Piece> vertexPieces, trianglePieces;
    std::size_t placeCount = 0, indexCount = 0;
    const auto divide = [](std::vector<Piece>& pieces, const Work& work, std::size_t items, std::size_t most) {
        for (std::size_t first = 0; first < items; first += most)
            pieces.push_back({&work, first, std::min(most, items - first)});
    };
    for (const Work& work : all) {
        if (work.view)
            divide(vertexPieces, work, work.positions.size(), kJobVertices);
        divide(trianglePieces, work, work.indices.size(), kJobIndices);
        placeCount = work.firstPlace + work.positions.size();
        indexCount = work.firstIndex + work.indices.size();
    }
    if (places.size() < placeCount)
        places.resize(placeCount);
    if (const vk::DeviceSize bytes = indexCount * sizeof(std::uint32_t);
        !*visible.indices.handle || visible.indices.size < bytes) // one there is even where nothing is seen
    {
        visible.indices = {}; // the old memory goes before the new comes
        visible.indices =
            gpu::makeBuffer(device, bytes, vk::BufferUsageFlagBits::eIndexBuffer, "indices of visible triangles");
    }

    const auto placesOf = [&](const Work& work) {
        return std::span(places).subspan(work.firstPlace, work.positions.size());
    };
    parallelFor(vertexPieces.size(), 1, [&](std::size_t i) {
        const Piece& piece = vertexPieces[i];
        placeVertices(*piece.work->view, piece.work->positions.subspan(piece.first, piece.count),
                      placesOf(*piece.work).subspan(piece.first, piece.count));
    });
    auto* const buffer = reinterpret_cast<std::uint32_t*>(visible.indices.mapped);
    parallelFor(trianglePieces.size(), 1, [&](std::size_t i) {
        Piece& piece = trianglePieces[i];
        const Work& work = *piece.work;
        const std::span<const std::uint32_t> indices = work.indices.subspan(piece.first, piece.count);
        std::uint32_t* const kept = buffer + work.firstIndex + piece.first;
        if (work.view)
            piece.kept = keepVisible(*work.view, indices, placesOf(work), kept);
        else {
            std::ranges::copy(indices, kept);
            piece.kept = indices.size();
        }
    });
    for (const Piece& piece : trianglePieces)
        if (piece.kept > 0)
            visible.draws[piece.work->draw].push_back({piece.work->instance,
                                                       static_cast<std::uint32_t>(piece.work->firstIndex + piece.first),
                                                       static_cast<std::uint32_t>(piece.kept)});
    return &visible;
}

} // namespace torrance
