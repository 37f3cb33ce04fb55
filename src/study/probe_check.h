// A shading term of the device against its double formula, and how much it may differ.
#pragma once

#include "passes/probe_pass.h"

#include <functional>
#include <string>
#include <vector>

namespace torrance {

/// A term, where it is looked at, and the greatest relative error there.
struct ProbeCheck
{
    ProbeTerm term;
    std::vector<brdf::ShadingPoint> rows;
    std::function<double(const brdf::ShadingPoint&)> allowed;
    std::function<dvec3(const brdf::ShadingPoint&)> terms = {}; // of a difference: errors are relative to them, too
};

/// The methods that methodCheck takes: all with a shading function but models, which brdfCheck looks at.
std::vector<const brdf::Method*> probedMethods();

/// A method with a shading function, over probeGrid. Both sides are fed the same scalars: only the function's own
/// arithmetic counts.
ProbeCheck methodCheck(const brdf::Method& method);

/// The whole BRDF from vectors, which are rounded on their way to the device: kappa decides what that may make of them.
ProbeCheck brdfCheck(const brdf::Preset& preset);

/// The table of directional albedos against the integral.
ProbeCheck albedoCheck();

/// The rows of slot dfg that are formulas and not tables; and one of them, over view cosines and roughnesses.
std::vector<const brdf::Method*> dfgFits();
ProbeCheck dfgFitCheck(const brdf::Method& fit);

struct ProbeWorst
{
    double ratio = -1; // error over what is allowed: at most 1 passes
    double error = 0;  // relative, of the worst channel
    std::size_t row = 0;
    vec3 device = vec3(0);
    dvec3 exact = dvec3(0);
};

ProbeWorst worstOf(const gpu::Device& device, gpu::ShaderLibrary& shaders, const ProbeCheck& check);

/// Over probeCorners: the first at which the method is not finite, is negative, is not 0 below the horizon (visibility,
/// diffuse) or above 1 (Fresnel). A sentence; empty where there is none.
std::string cornerFault(const gpu::Device& device, gpu::ShaderLibrary& shaders, const brdf::Method& method);

} // namespace torrance
