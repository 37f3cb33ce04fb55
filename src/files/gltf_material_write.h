// The changed members of a material, written into its glTF.
#pragma once

#include "files/json_ordered.h"
#include "scene/material.h"

namespace torrance {

/// Makes of the glTF material `json`, which reads as `before`, one that reads as `after`, and leaves alone every member
/// that did not change, known or not. Members at their defaults are left out. In both materials texture uses hold the
/// document's own numbers: of its textures, and of the sets TEXCOORD_n. Where no texture is used, a normal scale or
/// occlusion strength has no place in glTF and is not written.
void writeMaterial(OrderedJson& json, const Material& before, const Material& after);

} // namespace torrance
