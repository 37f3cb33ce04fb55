// The chart of methods as a page.
#pragma once

#include "study/chart_methods.h"
#include "study/chart_page.h"

namespace torrance {

/// A panel per slot. Where a chart comes from a table alone, there are no pictures.
ChartPage methodsPage(const MethodChart& chart);

} // namespace torrance
