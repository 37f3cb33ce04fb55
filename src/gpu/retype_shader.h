// The same GLSL in another precision: types and literals change, every operation stays.
#pragma once

#include "gpu/precision.h"
#include "gpu/shader_source.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace torrance::gpu {

/// `float`, `vecN` and `matN` become the types of the precision, and literals are given its suffix; directives,
/// comments and everything else stay as they are. fp32 comes back unchanged.
std::string retyped(std::string_view text, Precision precision);

/// retyped() on every file but `kept`; functions that nothing calls are left out, because they may use what the
/// precision does not have.
ShaderSource retyped(ShaderSource source, Precision precision, const std::set<std::string>& kept);

/// GLSL's functions that are called in the source and have no form in the precision: powers, exponentials and
/// trigonometry in 64 bits, bits of 32-bit words in all but 32. Sorted; asked of what retyped() gave.
std::vector<std::string> unavailableFunctions(const ShaderSource& source, Precision precision);

} // namespace torrance::gpu
