// A chart's page and drawing as files.
#pragma once

#include "study/chart_page.h"

#include <filesystem>
#include <string>

namespace torrance {

/// `name`.html and `name`.svg in the folder. Where this installation has no Vega, a warning instead of the page.
void writeChart(const std::filesystem::path& folder, const std::string& name, const ChartPage& page);

} // namespace torrance
