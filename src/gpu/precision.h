// The floating-point formats that a shader can compute in.
#pragma once

#include <string_view>

namespace torrance::gpu {

enum class Precision
{
    fp16,
    fp32,
    fp64,
};

constexpr std::string_view precisionName(Precision precision)
{
    constexpr std::string_view kNames[] = {"fp16", "fp32", "fp64"};
    return kNames[static_cast<int>(precision)];
}

} // namespace torrance::gpu
