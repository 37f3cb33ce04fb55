#include "files/obj_geometry.h"

#include "files/tinyobjloader.h"

#include <stdexcept>

namespace torrance {
namespace {

std::vector<vec3> triples(const std::vector<tinyobj::real_t>& values)
{
    std::vector<vec3> result(values.size() / 3);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = vec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
    return result;
}

} // namespace

ObjGeometry parseGeometry(const ObjText& text)
{
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, failure;
    ViewStream stream(text.geometry);
    // Whole polygons and no made-up colours. Its own cutting into triangles takes concave polygons wrongly, and its
    // counts of corners end at 255: ObjText::corners has them.
    const bool parsed = tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &failure, &stream, nullptr,
                                         /* triangulate = */ false, /* default_vcols_fallback = */ false);
    if (!parsed || shapes.size() != 1)
        throw std::runtime_error("tinyobjloader cannot read it: " + failure);

    ObjGeometry geometry;
    geometry.positions = triples(attributes.vertices);
    geometry.colors = triples(attributes.colors);
    geometry.normals = triples(attributes.normals);
    geometry.uvs.resize(attributes.texcoords.size() / 2);
    for (std::size_t i = 0; i < geometry.uvs.size(); ++i)
        geometry.uvs[i] = vec2(attributes.texcoords[2 * i], attributes.texcoords[2 * i + 1]);
    geometry.corners.reserve(shapes[0].mesh.indices.size());
    for (const tinyobj::index_t& index : shapes[0].mesh.indices)
        geometry.corners.push_back({index.vertex_index, index.texcoord_index, index.normal_index});
    return geometry;
}

} // namespace torrance
