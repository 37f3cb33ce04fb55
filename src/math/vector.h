// The vector types of the project: GLM's, float where the device's numbers are meant, double where truth is.
#pragma once

#include <glm/glm.hpp>

namespace torrance {

using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::ivec2;
using glm::mat3;
using glm::mat4;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline constexpr double kPi = 3.14159265358979323846;

} // namespace torrance
