#include "app/output_options.h"

#include "app/option_value.h"
#include "core/error.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <set>

namespace torrance {
namespace {

constexpr std::string_view kStem = "{stem}";

std::string withStem(std::string pattern, const std::string& input)
{
    const std::string stem = std::filesystem::path(input).stem().string();
    for (std::size_t at = pattern.find(kStem); at != std::string::npos; at = pattern.find(kStem, at + stem.size()))
        pattern.replace(at, kStem.size(), stem);
    return pattern;
}

// An option that would be ignored is an error: whoever gave it expects something of it.
void checkFormat(const OutputOptions& options, const std::string& name)
{
    const ImageFormat format = imageFormatOf(name); // an unknown format is said before anything is drawn
    if (isSceneLinear(format) && (!options.tone.empty() || !options.transfer.empty() || options.exposure))
        throw usageError(name + " holds scene-linear light, which --tone, --transfer and --exposure do not touch",
                         "leave them out, or write .png, .jpg or .webp");
    if (options.quality && format != ImageFormat::jpeg && format != ImageFormat::webp)
        throw usageError("--quality is for JPEG and WebP, and not for " + name, "leave it out");
    if (options.bits && format != ImageFormat::png)
        throw usageError("--bits is for PNG, and not for " + name, "leave it out; EXR holds 32-bit float");
}

} // namespace

void declareOutputOptions(CLI::App& app, OutputOptions& options)
{
    const char* group = "Output";
    app.add_option("-o,--output", options.pattern,
                   "Picture to write: .png, .jpg, .webp (display-referred), .exr, .hdr (scene-linear); '-' writes PNG "
                   "to standard output; {stem} stands for the input's name")
        ->group(group)
        ->type_name("FILE")
        ->required();
    declareCurveOptions(app, options);
    app.add_option("--bits", options.bits, "Bits per channel of PNG: 8 (default) or 16")
        ->group(group)
        ->check(CLI::IsMember({8, 16}));
    app.add_option("--quality", options.quality, "Of JPEG and WebP, 1 to 100 (default 95)")
        ->group(group)
        ->check(CLI::Range(1, 100));
}

void declareCurveOptions(CLI::App& app, OutputOptions& options)
{
    const char* group = "Output";
    std::vector<std::string> curves;
    for (const ToneCurve& curve : allToneCurves())
        curves.emplace_back(curve.id);
    addChoice(app, "--tone", options.tone, curves,
              "Tone curve of display-referred pictures, khronos_neutral unless given")
        ->group(group);
    std::vector<std::string> transfers;
    for (const TransferCurve& curve : allTransferCurves())
        transfers.emplace_back(curve.id);
    addChoice(app, "--transfer", options.transfer, transfers,
              "Encoding of display-referred pictures, srgb unless given")
        ->group(group);
    app.add_option("--exposure", options.exposure, "Stops added before the tone curve of display-referred pictures")
        ->group(group);
}

std::vector<std::string> outputNames(const OutputOptions& options, const std::vector<std::string>& inputs)
{
    if (options.exposure && !std::isfinite(*options.exposure))
        throw usageError("--exposure must be a number", "give stops, such as 1 or -0.5");
    std::vector<std::string> names;
    std::set<std::string> seen;
    for (const std::string& input : inputs) {
        names.push_back(withStem(options.pattern, input));
        checkFormat(options, names.back());
        if (!seen.insert(names.back()).second)
            throw usageError("two inputs would be written to " + names.back(),
                             "put {stem} into --output, and give inputs different names");
    }
    return names;
}

WriteSettings writeSettings(const OutputOptions& options, const brdf::Preset& methods)
{
    WriteSettings settings;
    settings.exposure = options.exposure.value_or(settings.exposure);
    settings.bitsPerChannel = options.bits.value_or(settings.bitsPerChannel);
    settings.quality = options.quality.value_or(settings.quality);
    settings.tone = findToneCurve(options.tone.empty() ? methods.tone : options.tone);
    settings.transfer = findTransferCurve(options.transfer.empty() ? methods.transfer : options.transfer);
    return settings;
}

} // namespace torrance
