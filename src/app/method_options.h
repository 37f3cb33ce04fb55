// A preset and, slot by slot, other methods: the registry on the command line.
#pragma once

#include "brdf/method.h"

#include <map>
#include <string>

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
