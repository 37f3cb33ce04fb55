#include "app/phases.h"

#include <algorithm>

namespace torrance {

void Phases::add(const std::string& name, double seconds)
{
    const auto found = std::ranges::find(list, name, [](const auto& phase) { return phase.first; });
    if (found != list.end())
        found->second += seconds;
    else
        list.emplace_back(name, seconds);
}

} // namespace torrance
