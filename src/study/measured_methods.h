// What a sweep measured of each method, kept in a table for the documentation.
#pragma once

#include "study/method_verdict.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace torrance {

struct MeasuredMethod
{
    std::string method;         // "distribution/ggx"
    std::optional<double> fp32; // worst error; empty where it cannot be evaluated, infinite where it is not finite
    std::optional<double> fp16;
    std::string models;  // "beckmann 68 (rms 9.6)", one after the other
    double energy = 0.0; // the greatest returned; 0 where it is not defined
};

/// Of a verdict that holds both precisions.
MeasuredMethod measuredMethod(const MethodVerdict& verdict);

/// Columns and rows of the maps from which the documentation's figures are taken.
inline constexpr AtlasSize kMeasuredSize = {.map = 24, .physics = 8};

std::string measuredCsv(std::span<const MeasuredMethod> methods);

/// Errors (input) name `file`: as of csv_read.h, and for an error that is neither a number nor "inf" nor empty.
std::vector<MeasuredMethod> readMeasured(std::string_view csv, const std::string& file);

} // namespace torrance
