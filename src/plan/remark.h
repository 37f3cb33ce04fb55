// What the plan did and why, a line each: the text of --explain.
#pragma once

#include <string>
#include <vector>

namespace torrance {

struct Remark
{
    std::string subject; // "material 'Label'", "light 2", "environment"
    std::string choice;  // "no occlusion texture"
    std::string reason;  // "all texels are 1"
};

using Remarks = std::vector<Remark>;

} // namespace torrance
