// What a device conforms to, for people and for build servers.
#pragma once

#include "study/conformance.h"
#include "study/html_report.h"
#include "study/junit.h"

#include <span>

namespace torrance {

/// Why a result did not pass, in one line.
std::string shortFault(const ConformanceResult& result);

/// A suite per group. The message of a failure is one line, its details say what was expected.
std::vector<JunitSuite> conformanceSuites(std::span<const ConformanceGroup> groups);

/// A table per group, all its pictures on contact sheets (drawn, exact, difference), and the worst and the failed ones
/// large.
HtmlReport conformanceReport(std::span<const ConformanceGroup> groups, const gpu::DeviceDescription& device);

} // namespace torrance
