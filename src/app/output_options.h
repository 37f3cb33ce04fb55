// How a picture leaves the program.
#pragma once

#include "files/image_write.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace torrance {

struct OutputOptions
{
    std::string pattern; // a file, "-", or with {stem} for each input's name
    std::string tone = "khronos_neutral";
    double exposure = 0.0; // stops
    int bits = 8;
    int quality = 95;
};

void declareOutputOptions(CLI::App& app, OutputOptions& options);

/// One output per input. Error (usage) where two inputs would write one file, or the format is not known.
std::vector<std::string> outputNames(const OutputOptions& options, const std::vector<std::string>& inputs);

WriteSettings writeSettings(const OutputOptions& options);

} // namespace torrance
