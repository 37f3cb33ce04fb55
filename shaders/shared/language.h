// Lets one text be read by C++ and by GLSL. Structs use the scalar layout: the same offsets in both, no padding members.
#ifndef TORRANCE_SHARED_LANGUAGE_H
#define TORRANCE_SHARED_LANGUAGE_H

#ifdef __cplusplus

#include "math/vector.h"

#include <cstdint>

#define SHARED_BEGIN namespace torrance::shared {
#define SHARED_END }
#define SHARED_UINT(name, value) inline constexpr std::uint32_t name = value

namespace torrance::shared {
using uint = std::uint32_t;
}

#else

#define SHARED_BEGIN
#define SHARED_END
#define SHARED_UINT(name, value) const uint name = value

#endif

#endif
