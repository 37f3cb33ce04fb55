// The statements of an MTL file, checked, in the form that tinyobjloader reads without fault.
#pragma once

#include "files/load_report.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace torrance {

struct MtlEntry
{
    std::string name;
    std::set<std::string> keys; // that the file states: a value that it leaves out is no value
};

struct MtlText
{
    std::string statements; // newmtl 0, newmtl 1, ... numbered as `materials`, and what tinyobjloader knows
    std::vector<MtlEntry> materials;
};

/// Colours get three numbers, texture options all of theirs, keys the spelling of the format. Keys without a meaning
/// here are passed over, those that describe something that is not drawn with a warning. NaN and infinite numbers
/// become 0 and are counted. Errors (input) name the line: a value that is no number, a map without a name, an unknown
/// option.
MtlText readMtlText(std::string_view text, LoadReport& report);

} // namespace torrance
