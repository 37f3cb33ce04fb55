// A shading term on the device, for many points at once.
#pragma once

#include "gpu/device.h"
#include "gpu/shader_library.h"
#include "passes/probe_term.h"

#include <span>
#include <vector>

namespace torrance {

/// The term at every point as the device computes it from the point's members, each rounded to float. Throws Error
/// (deviceFailure).
std::vector<vec3> probe(const gpu::Device& device, gpu::ShaderLibrary& shaders, const ProbeTerm& term,
                        std::span<const brdf::ShadingPoint> points);

} // namespace torrance
