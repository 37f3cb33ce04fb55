// One method on the device, in every precision, against its formula in double.
#pragma once

#include "gpu/device.h"
#include "gpu/shader_library.h"
#include "study/sweep_points.h"

#include <string>
#include <vector>

namespace torrance {

/// What the points of a cell came to.
struct CellError
{
    double error = 0.0;      // relative, the greatest of points and channels; infinite where the device's value is not
                             // finite
    double excess = 0.0;     // the greatest error over what the inputs' own rounding explains: allowedError()
    brdf::ShadingPoint at;   // where the error is greatest
    dvec3 device = dvec3(0); // and the values there, as valueAsRead()
    dvec3 exact = dvec3(0);
    int nonFinite = 0; // number of points
    int negative = 0;
};

struct PrecisionSweep
{
    gpu::Precision precision = gpu::Precision::fp32;
    std::string refusal;          // why the method cannot be evaluated in this precision; then there are no cells
    std::vector<CellError> cells; // row by row, a row per value of SweepAxes::rows
};

struct MethodSweep
{
    const brdf::Method* method = nullptr;
    SweepAxes axes;
    std::vector<PrecisionSweep> precisions;
};

/// True for methods with a function of a shading point on the device.
bool canSweep(const brdf::Method& method);

/// What a material makes of a DFG term: the light of a dielectric's and of a white lobe under uniform light, and what
/// is left for the diffuse one. Values of other slots as they are.
dvec3 valueAsRead(brdf::Slot slot, const dvec3& value);

/// True for tables that store less than the row `table`: what they are off by is no rounding, but what they save.
bool isCoarserTable(const brdf::Method& method);

/// Every point is evaluated from its scalars rounded, and moved one unit in the last place up and down: what is known
/// of a cosine on a device. Throws Error (deviceFailure).
PrecisionSweep sweepMethod(const gpu::Device& device, gpu::ShaderLibrary& shaders, const brdf::Method& method,
                           const SweepAxes& axes, gpu::Precision precision);

/// 1e-4, and twice what the rounding of the vectors and of the roughness makes of the formula: 2 kappa u
/// (brdf/condition.h). Without bound for coarser tables.
double allowedError(const brdf::Method& method, const brdf::ShadingPoint& point, gpu::Precision precision);

} // namespace torrance
