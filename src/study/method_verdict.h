// What a sweep of a method says, in numbers and in words.
#pragma once

#include "study/method_sweep.h"
#include "study/model_error.h"

#include <string>
#include <vector>

namespace torrance {

/// Where something happens on a map: the least and the greatest row and cosine among its cells.
struct Extent
{
    int cells = 0;
    double leastRow = 0.0, greatestRow = 0.0;
    double leastCosine = 0.0, greatestCosine = 0.0;
};

struct PrecisionVerdict
{
    gpu::Precision precision = gpu::Precision::fp32;
    std::string refusal;
    CellError worst; // of the finite errors
    Extent above4;   // error > 1e-4
    Extent above2;   // error > 1e-2
    Extent nonFinite;
    Extent negative;
    Extent unexplained; // more than allowedError()
};

struct ModelVerdict
{
    const brdf::Method* approximated = nullptr;
    std::vector<ModelCell> cells;
    ModelCell worst;
    double rms = 0.0; // of the cells' errors
    Extent above1;    // error > 0.1
};

struct MethodVerdict
{
    const brdf::Method* method = nullptr;
    SweepAxes axes;
    std::vector<PrecisionSweep> sweeps;
    std::vector<PrecisionVerdict> precisions;
    std::vector<ModelVerdict> models;
    SweepAxes physicsAxes; // of what follows
    double energy = 0.0;   // the greatest returnedEnergy(); 0 where it is not defined
    Extent gainsEnergy;    // above 1 + kEnergySlack
    double reciprocity = 0.0;
    Extent notReciprocal; // above kReciprocityRounding
};

/// A double's rounding, 2^-53, as the slopes of the narrowest highlight magnify it: by up to 1e9.
inline constexpr double kReciprocityRounding = 1e-6;

struct AtlasSize
{
    int map = 64;     // columns and rows of the maps
    int physics = 12; // of energy and reciprocity
};

/// All of it, for the precisions that are named. Throws Error (deviceFailure).
MethodVerdict judgeMethod(const gpu::Device& device, gpu::ShaderLibrary& shaders, const brdf::Method& method,
                          const AtlasSize& size, std::span<const gpu::Precision> precisions);

/// One line each, for people.
std::vector<std::string> verdictLines(const MethodVerdict& verdict);

} // namespace torrance
