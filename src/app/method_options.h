// A preset and, slot by slot, other methods: the registry on the command line.
#pragma once

#include "brdf/method.h"

#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace torrance {

/// Options of a source system's model (brdf/model_options.h).
struct ModelChoices
{
    std::string quirks;     // "NAME,NAME"
    std::string parameters; // "NAME=VALUE,NAME=VALUE"
};

/// Of a slot, as the command line takes them.
std::vector<std::string> methodIds(brdf::Slot slot);

/// --quirk and --parameter.
void declareModelChoices(CLI::App& app, ModelChoices& choices);

/// Error (usage) for what the preset's model does not have, and for numbers out of range.
void applyModelChoices(const ModelChoices& choices, brdf::Preset& preset);

struct MethodOptions
{
    std::string preset = "standard";
    std::map<brdf::Slot, std::string> overrides; // "" = the preset's
    ModelChoices model;
};

/// --preset, --quirk, --parameter, and one option per slot of a preset: --distribution, --visibility, ...
void declareMethodOptions(CLI::App& app, MethodOptions& options);

brdf::Preset chooseMethods(const MethodOptions& options);

} // namespace torrance
