#include "plan/primitive_facts.h"

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace torrance {
namespace {

/// A fixed number of slots with linear probing: as many again as there will be keys.
class SlotTable
{
public:
    explicit SlotTable(std::size_t keys) : slots(std::bit_ceil(2 * keys + 1), kFree) {}

    /// The slot that holds a value for which `same` is true, or the free one where it belongs.
    template <typename Same>
    std::uint32_t& find(std::uint64_t hash, const Same& same)
    {
        std::size_t at = hash & (slots.size() - 1);
        while (slots[at] != kFree && !same(slots[at]))
            at = (at + 1) & (slots.size() - 1);
        return slots[at];
    }

    static constexpr std::uint32_t kFree = UINT32_MAX;

private:
    std::vector<std::uint32_t> slots;
};

std::uint64_t mixed(std::uint64_t x)
{
    x ^= x >> 32; // the finalizer of Steele, Lea & Flood 2014, Fast Splittable Pseudorandom Number Generators
    x *= 0xd6e8feb86659fd93u;
    x ^= x >> 32;
    x *= 0xd6e8feb86659fd93u;
    return x ^ x >> 32;
}

std::uint64_t hashOf(const vec3& p)
{
    const auto bits = std::bit_cast<std::array<std::uint32_t, 3>>(p + 0.0f); // -0 is 0
    return mixed(mixed(std::uint64_t(bits[0]) << 32 | bits[1]) + bits[2]);
}

/// The triangles that are not mere lines, as numbers of their corners' places, and where those are.
struct Surface
{
    std::vector<std::uint32_t> corners; // three a triangle
    std::vector<vec3> places;
};

Surface surfaceOf(const Primitive& primitive)
{
    std::vector<std::uint32_t> placeOfVertex(primitive.positions.size(), SlotTable::kFree);
    Surface surface;
    SlotTable table(primitive.positions.size());
    const auto placeOf = [&](std::uint32_t index) {
        std::uint32_t& place = placeOfVertex[index];
        if (place == SlotTable::kFree) {
            const vec3& p = primitive.positions[index];
            std::uint32_t& slot =
                table.find(hashOf(p), [&](std::uint32_t known) { return surface.places[known] == p; });
            if (slot == SlotTable::kFree) {
                slot = static_cast<std::uint32_t>(surface.places.size());
                surface.places.push_back(p);
            }
            place = slot;
        }
        return place;
    };
    surface.corners.reserve(primitive.indices.size());
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const std::array corners = {placeOf(primitive.indices[i]), placeOf(primitive.indices[i + 1]),
                                    placeOf(primitive.indices[i + 2])};
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            surface.corners.insert(surface.corners.end(), corners.begin(), corners.end());
    }
    return surface;
}

/// Every edge joins two triangles that run along it in opposite senses.
bool isClosed(const Surface& surface)
{
    const std::vector<std::uint32_t>& corners = surface.corners;
    // Corner i of the triangle i / 3 starts the half edge to that triangle's next corner.
    const auto from = [&](std::size_t edge) { return corners[edge]; };
    const auto to = [&](std::size_t edge) { return corners[edge - edge % 3 + (edge + 1) % 3]; };
    SlotTable table(corners.size());
    const auto find = [&](std::uint32_t a, std::uint32_t b) -> std::uint32_t& {
        return table.find(mixed(std::uint64_t(a) << 32 | b),
                          [&](std::uint32_t edge) { return from(edge) == a && to(edge) == b; });
    };
    for (std::size_t edge = 0; edge < corners.size(); ++edge) {
        std::uint32_t& slot = find(from(edge), to(edge));
        if (slot != SlotTable::kFree)
            return false; // a second triangle along it in the same sense
        slot = static_cast<std::uint32_t>(edge);
    }
    for (std::size_t edge = 0; edge < corners.size(); ++edge)
        if (find(to(edge), from(edge)) == SlotTable::kFree)
            return false; // an open edge
    return true;
}

/// Six times the signed volume of the tetrahedron of a triangle and the origin.
double spanned(const dvec3& a, const dvec3& b, const dvec3& c)
{
    return glm::dot(a, glm::cross(b, c));
}

/// Seen from the middle of the box, every triangle shows its back, and one direction, into the first triangle, meets
/// that one alone.
bool surroundsOnce(const Primitive& primitive)
{
    const dvec3 middle = 0.5 * (primitive.boundsMin + primitive.boundsMax);
    const auto place = [&](std::size_t corner) {
        return dvec3(primitive.positions[primitive.indices[corner]]) - middle;
    };
    dvec3 direction(0.0);
    int met = 0;
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const dvec3 a = place(i), b = place(i + 1), c = place(i + 2);
        if (a == b || b == c || c == a)
            continue; // a mere line
        if (direction == dvec3(0.0))
            direction = (a + b + c) / 3.0;
        if (!(spanned(a, b, c) > 0.0))
            return false;
        if (spanned(direction, a, b) >= 0.0 && spanned(direction, b, c) >= 0.0 && spanned(direction, c, a) >= 0.0)
            ++met;
    }
    return met == 1;
}

} // namespace

bool normalsMayVanish(const Primitive& primitive)
{
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const vec3 &a = primitive.normals[primitive.indices[i]], &b = primitive.normals[primitive.indices[i + 1]],
                   &c = primitive.normals[primitive.indices[i + 2]];
        if (!(glm::dot(a, b) > 0.0f && glm::dot(b, c) > 0.0f && glm::dot(c, a) > 0.0f))
            return true;
    }
    return false;
}

bool isStarBody(const Primitive& primitive)
{
    // The cheaper part of the test first: most bodies fail it at one of their first triangles.
    return primitive.topology == Topology::triangles && surroundsOnce(primitive) && isClosed(surfaceOf(primitive));
}

} // namespace torrance
