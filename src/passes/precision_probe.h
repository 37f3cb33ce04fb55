// A shading term on the device in a chosen precision, for many points at once.
#pragma once

#include "gpu/device.h"
#include "gpu/pipeline.h"
#include "gpu/shader_library.h"
#include "passes/probe_term.h"

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace torrance {

/// A pipeline whose GLSL, from the row to the value, is the term's own text in the types of the precision.
struct PrecisionProbe
{
    gpu::Precision precision;
    gpu::Pipeline pipeline;
};

/// Or why the term cannot be had in this precision: "exp has no 64-bit form in GLSL". Throws Error (deviceFailure).
std::variant<PrecisionProbe, std::string> makePrecisionProbe(const gpu::Device& device, gpu::ShaderLibrary& shaders,
                                                             const ProbeTerm& term, gpu::Precision precision);

/// The term at every point, from the point's members rounded to the precision. Throws Error (deviceFailure).
std::vector<dvec3> probe(const gpu::Device& device, const PrecisionProbe& probe,
                         std::span<const brdf::ShadingPoint> points);

} // namespace torrance
