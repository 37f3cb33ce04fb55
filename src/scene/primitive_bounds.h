// The box round a primitive.
#pragma once

#include "scene/scene.h"

namespace torrance {

/// Sets boundsMin and boundsMax from the vertices that an index names. The primitive has at least one index.
void setBounds(Primitive& primitive);

} // namespace torrance
