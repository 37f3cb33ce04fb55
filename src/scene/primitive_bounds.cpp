#include "scene/primitive_bounds.h"

namespace torrance {

void setBounds(Primitive& primitive)
{
    primitive.boundsMin = primitive.boundsMax = dvec3(primitive.positions[primitive.indices[0]]);
    for (const std::uint32_t index : primitive.indices) {
        primitive.boundsMin = glm::min(primitive.boundsMin, dvec3(primitive.positions[index]));
        primitive.boundsMax = glm::max(primitive.boundsMax, dvec3(primitive.positions[index]));
    }
}

} // namespace torrance
