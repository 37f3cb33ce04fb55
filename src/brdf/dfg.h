// What the slot dfg stands for: the directional albedo terms of the glTF material's lobes.
#pragma once

#include "math/vector.h"

namespace torrance::brdf {

/// (scale, bias, w) of albedo.h: the integrals that the table holds at its nodes. NoV, perceptualRoughness in [0, 1].
dvec3 DFG_table(double NoV, double perceptualRoughness);

/// E = scale + bias. The last one is kept, per thread: whoever integrates over l asks for the same one each time, and
/// it takes ten thousand times as long as a BRDF.
double lobeAlbedo(double NoV, double perceptualRoughness);

} // namespace torrance::brdf
