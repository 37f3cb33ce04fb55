// What `torrance bench` measured, for people.
#pragma once

#include "study/bench_frames.h"
#include "study/bench_record.h"
#include "study/growth.h"
#include "study/soak.h"

#include <string>
#include <vector>

namespace torrance {

std::string textOf(const BenchRecord& record, const BenchBounds& bounds);
std::string textOf(const std::vector<SpeedComparison>& comparisons, double limit);
std::string textOf(const GrowthMeasurement& measurement, BenchClock clock);
/// Of one cost, in seconds ("s") or bytes ("B").
std::string textOf(const GrowthFit& fit, const GrowthMeasurement& measurement, const std::string& unit);
std::string textOf(const SoakVerdict& verdict, std::size_t renders);

/// A number with three digits and a prefix: "12.3 ms", "41 us", "1.2 GB" for unit "s" or "B".
std::string withPrefix(double value, const std::string& unit);

} // namespace torrance
