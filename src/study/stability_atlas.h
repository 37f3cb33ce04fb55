// What sweeps of methods came to, as files: maps, tables and a report.
#pragma once

#include "study/html_report.h"
#include "study/method_verdict.h"

#include <span>
#include <string>
#include <vector>

namespace torrance {

struct AtlasMap
{
    std::string file; // "distribution_ggx_fp32.png"
    std::string title;
    Image picture;
};

/// What is kept of a verdict: some hundred kilobytes instead of megabytes.
struct AtlasEntry
{
    std::string name;    // "distribution/ggx"
    std::string csvFile; // "distribution_ggx.csv"
    std::string csv;     // every cell of every precision and model, with its worst point
    std::vector<AtlasMap> maps;
    std::string legend;
    std::vector<std::string> lines; // of the verdict
    bool sound = true;              // nothing in 32 bits is for a reader to worry about
};

/// "distribution/ggx".
std::string methodName(const brdf::Method& method);

AtlasEntry atlasEntry(const MethodVerdict& verdict);

/// Links to the tables, which lie beside it. The same entries give the same bytes.
HtmlReport atlasReport(std::span<const AtlasEntry> entries, const std::string& deviceName);

} // namespace torrance
