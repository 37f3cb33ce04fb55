// A row's domain held to account by a sweep.
#pragma once

#include "gpu/device.h"
#include "gpu/shader_library.h"
#include "study/sweep_points.h"

#include <string>
#include <vector>

namespace torrance {

/// What contradicts the method's domain and claims, a line each, in 32 bits. Inside: not finite, negative, further from
/// the formula than allowedError(); energy gained or reciprocity lost against the row's word; where the method stands
/// for exact_dielectric, total reflection missed. And claims that nothing supports: a bound outside of which, within
/// ten per cent, nothing of this happens; `gainsEnergy` or no reciprocity that is not found.
std::vector<std::string> domainContradictions(const gpu::Device& device, gpu::ShaderLibrary& shaders,
                                              const brdf::Method& method);

} // namespace torrance
