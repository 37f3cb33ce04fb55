// How a picture leaves the program.
#pragma once

#include "brdf/method.h"
#include "files/image_write.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace torrance {

struct OutputOptions
{
    std::string pattern;            // a file, "-", or with {stem} for each input's name
    std::string tone;               // empty: khronos_neutral
    std::string transfer;           // empty: srgb
    std::optional<double> exposure; // stops, 0
    std::optional<int> bits;        // 8
    std::optional<int> quality;     // 95
};

void declareOutputOptions(CLI::App& app, OutputOptions& options);

/// --tone, --transfer and --exposure alone.
void declareCurveOptions(CLI::App& app, OutputOptions& options);

/// One output per input. Error (usage) where two inputs would write one file, the format is not known, or an option was
/// given that means nothing to it.
std::vector<std::string> outputNames(const OutputOptions& options, const std::vector<std::string>& inputs);

/// Tone and transfer curves are the preset's where none is given.
WriteSettings writeSettings(const OutputOptions& options, const brdf::Preset& methods);

} // namespace torrance
