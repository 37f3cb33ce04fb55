// The text that makes one set of methods the shader's.
#pragma once

#include "brdf/method.h"

#include <string>

namespace torrance::brdf {

/// Contents of the generated file `selected.glsl`: for every slot with a shading function the line that includes its
/// file (paths from the shaders' root) and `#define SELECTED_<slot> <prefix>_<id>`. Throws as requireWholeBrdf
/// (brdf.h).
std::string selectedGlsl(const Preset& preset);

/// Such as "brdf/distribution/ggx.glsl", from the shaders' root.
std::string glslPath(const Method& method);
/// Such as "D_ggx": the function's name in GLSL and in C++.
std::string functionName(const Method& method);

} // namespace torrance::brdf
