#include "app/phases.h"

#include "app/progress_line.h"
#include "core/log.h"

#include <algorithm>
#include <cstdio>

namespace torrance {

void Phases::add(const std::string& name, double seconds)
{
    const auto found = std::ranges::find(list, name, [](const auto& phase) { return phase.first; });
    if (found != list.end())
        found->second += seconds;
    else
        list.emplace_back(name, seconds);
}

Json phasesAsJson(const Phases& phases)
{
    Json::Object object;
    for (const auto& [name, seconds] : phases.all())
        object.emplace_back(name, seconds);
    return object;
}

void reportPhases(const Phases& phases)
{
    std::string text;
    for (const auto& [name, seconds] : phases.all()) {
        char part[64];
        std::snprintf(part, sizeof part, "%s%s %.0f ms", text.empty() ? "" : ", ", name.c_str(), seconds * 1000.0);
        text += part;
    }
    if (peopleAreWatching() && logLevel() != LogLevel::verbose)
        std::fprintf(stderr, "%s\n", text.c_str());
    logInfo("phases: " + text);
}

} // namespace torrance
