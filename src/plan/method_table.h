// What each shading method was measured to cost and to be off by, on one device: what a choice between methods is made
// from. Plain data; study/method_table_file.h reads and writes it.
#pragma once

#include "brdf/method.h"

#include <optional>
#include <string>
#include <vector>

namespace torrance {

/// Surfaces on which errors were measured: every perceptual roughness with every reflectance at normal incidence (0.04
/// is a dielectric with a body, the others are metals), seen at n.v between neighbouring edges. Ascending.
struct MethodGrid
{
    std::vector<double> roughnesses;
    std::vector<double> reflectances;
    std::vector<double> cosines; // edges: one more than there are columns

    std::size_t columns() const { return cosines.size() - 1; }
    std::size_t cells() const { return reflectances.size() * roughnesses.size() * columns(); }
    std::size_t cell(std::size_t reflectance, std::size_t roughness, std::size_t column) const
    {
        return (reflectance * roughnesses.size() + roughness) * columns() + column;
    }
    bool operator==(const MethodGrid&) const = default;
};

/// A number with its 95 % interval.
struct Measured
{
    double median = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// Of a frame whose other slots hold the preset `standard`.
struct MethodCost
{
    Measured nanoseconds; // a pixel
    Measured ratio;       // to the slot's reference method, drawn in turn with it
    std::size_t frames = 0;
};

/// Of pictures against the method's truth, scene-linear. Of a pixel |d - c|_1 / (|c|_1 + 1 % of the mean |c|_1).
struct MethodError
{
    double mean = 0.0;  // sum of |d - c|_1 over that of |c|_1
    double rms = 0.0;   // of the pixels'
    double worst = 0.0; // pixel
    double flip = 0.0;  // mean HDR-FLIP
    double noise = 0.0; // of `mean`, what the truth's own 95 % interval makes of it; 0 where the truth is exact
    /// By MethodGrid::cell: `mean` and `worst` of the cell's pixels; NaN where the truth is black. Empty where a slot
    /// is not judged on surfaces.
    std::vector<double> cells;
    std::vector<double> cellWorst;
};

struct MethodRow
{
    const brdf::Method* method = nullptr;
    std::string truth; // what it was held against; methods of one slot and one truth can stand in for each other
    std::string note;  // why there is no cost or no error; empty where there are both
    std::optional<MethodCost> cost;
    std::optional<MethodError> error;
};

struct MethodTable
{
    std::string program;
    std::string date;
    std::string processor;
    int cores = 0;
    std::string system;
    std::string device;
    std::string driver; // name and version
    std::string environment;
    MethodGrid grid;
    std::vector<MethodRow> rows; // in the registry's order
};

} // namespace torrance
