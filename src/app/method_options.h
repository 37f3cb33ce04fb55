// A preset and, slot by slot, other methods: the registry on the command line.
#pragma once

#include "brdf/method.h"

#include <map>
#include <string>

namespace CLI {
class App;
}

namespace torrance {

struct MethodOptions
{
    std::string preset = "standard";
    std::map<brdf::Slot, std::string> overrides; // "" = the preset's
};

/// --preset and one option per slot of a preset: --distribution, --visibility, ...
void declareMethodOptions(CLI::App& app, MethodOptions& options);

brdf::Preset chooseMethods(const MethodOptions& options);

} // namespace torrance
