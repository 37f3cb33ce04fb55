// --tolerance: how far a picture may be off, and what was chosen for it.
#pragma once

#include "files/json_write.h"
#include "plan/tolerance.h"
#include "study/tolerance_search.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace torrance {

struct ToleranceOption
{
    std::string mean; // empty: by name standard
    std::string percentile99;
    std::string methods = "shipped";
    const CLI::Option* given = nullptr;
};

void declareToleranceOption(CLI::App& app, ToleranceOption& option);

/// A mean error as --tolerance takes it: a share or a name; "" is standard. Error (usage) as below.
double parseTolerance(const std::string& text);

/// Nothing where none was asked for. Error (usage) for a share that is not above 0 and at most 1, and for options that
/// belong to a tolerance and have none.
std::optional<Tolerance> chosenTolerance(const ToleranceOption& option);

/// The options of the picture that was found, in place of the tolerance that it was found by: the same picture without
/// a search.
std::vector<std::string> argumentsFound(std::vector<std::string> arguments, const ToleranceResult& found);

Json toleranceJson(const ToleranceResult& result, const std::string& tableHash);

/// Of toleranceLines.
std::string toleranceText(const ToleranceResult& result);

} // namespace torrance
