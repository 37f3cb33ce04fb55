// The measured table of methods as a file: methods.measured.json.
#pragma once

#include "files/json_parse.h"
#include "plan/method_table.h"

#include <string_view>

namespace torrance {

inline constexpr std::string_view kMethodTableSchema = "torrance-methods/1";

/// Errors of cells are rounded to three digits: what a cell of some dozen pixels is worth.
Json asJson(const MethodTable& table);
Json asJson(const MethodRow& row);

/// Errors (input) name `file` and the place: damaged, of another schema, a number missing or out of range, cells that
/// are not the grid's, methods that this program does not have or has beside those of the table.
MethodTable parseMethodTable(std::string_view text, const std::string& file);
/// One row, on a grid.
MethodRow methodRowFrom(const JsonView& json, const MethodGrid& grid);

/// An Error (input) names `file` where its costs are another device's or driver's.
void requireDevice(const MethodTable& table, const std::string& file, const std::string& device,
                   const std::string& driver);

} // namespace torrance
