#include "app/command_compare.h"

#include "core/atomic_write.h"
#include "core/log.h"
#include "core/standard_output.h"
#include "files/image_encoders.h"
#include "files/image_read.h"
#include "files/image_write.h"
#include "files/json_write.h"
#include "image/srgb.h"
#include "measure/heat_map.h"
#include "measure/picture_comparison.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace torrance {
namespace {

/// What can be limited: its option is --max-<name>.
enum class Quantity
{
    relMse,
    rmse,
    smape,
    flip,
    flip99,
    worst,
    alpha,
    nonFinite,
};

struct QuantityName
{
    Quantity quantity;
    const char* option;
    const char* text;
    const char* meaning;
};

constexpr QuantityName kQuantities[] = {
    {Quantity::relMse, "relmse", "relMSE", "mean of (t-r)^2 / (r^2 + 0.01)"},
    {Quantity::rmse, "rmse", "RMSE", "root of the mean of (t-r)^2"},
    {Quantity::smape, "smape", "SMAPE", "mean of |t-r| / (|t| + |r| + 0.01)"},
    {Quantity::flip, "flip", "mean FLIP", "mean FLIP at 67 pixels per degree"},
    {Quantity::flip99, "flip-p99", "99th percentile of FLIP", "99th percentile of FLIP"},
    {Quantity::worst, "pixel-error", "worst pixel", "error of the worst pixel, relative to its colour"},
    {Quantity::alpha, "alpha", "alpha difference", "largest difference of alpha"},
    {Quantity::nonFinite, "non-finite", "non-finite pixels", "number of pixels of TEST with a NaN or Inf"},
};

struct Options
{
    std::string reference;
    std::string test;
    std::string heatMap;
    std::optional<double> limits[std::size(kQuantities)];
};

double valueOf(Quantity quantity, const PictureComparison& comparison)
{
    switch (quantity) {
    case Quantity::relMse:
        return comparison.metrics.relMse;
    case Quantity::rmse:
        return comparison.metrics.rmse;
    case Quantity::smape:
        return comparison.metrics.smape;
    case Quantity::flip:
        return comparison.meanFlip;
    case Quantity::flip99:
        return comparison.flip99;
    case Quantity::worst:
        return comparison.metrics.worst.error;
    case Quantity::alpha:
        return comparison.maxAlphaDifference;
    case Quantity::nonFinite:
        break;
    }
    return static_cast<double>(comparison.metrics.nonFiniteTest);
}

std::string problemWithLimit(const std::string& text)
{
    double value = 0.0;
    const bool number = CLI::detail::lexical_cast(text, value);
    return number && std::isfinite(value) && value >= 0.0 ? "" : text + " is no limit, give a number of at least 0";
}

void declare(CLI::App& app, Options& options)
{
    app.add_option("REFERENCE", options.reference, "The picture that is right")->required()->type_name("FILE");
    app.add_option("TEST", options.test, "The picture to be judged, of the same size and kind")
        ->required()
        ->type_name("FILE");
    app.add_option("--heat-map", options.heatMap, "Write FLIP per pixel as colours (.png)")->type_name("FILE");
    options.limits[static_cast<std::size_t>(Quantity::nonFinite)] = 0.0; // the number that is allowed
    for (std::size_t i = 0; i < std::size(kQuantities); ++i)
        app.add_option(std::string("--max-") + kQuantities[i].option, options.limits[i],
                       std::string("Fail above this ") + kQuantities[i].meaning)
            ->type_name("X")
            ->check(problemWithLimit)
            ->group("Limits");
    app.footer(
        "Exit code 1 where a limit is exceeded. Pixels with a NaN or Inf are counted and left out of the norms; one in "
        "TEST\n"
        "fails the comparison unless --max-non-finite allows it. Colours are compared linear and over black; FLIP is\n"
        "LDR-FLIP for PNG, JPEG and WebP, HDR-FLIP for EXR and HDR.");
}

std::optional<std::size_t> alphaChannel(const ReadImage& picture)
{
    const auto& names = picture.channelNames;
    const auto place = std::find(names.begin(), names.end(), "A");
    return place == names.end() ? std::nullopt : std::optional(static_cast<std::size_t>(place - names.begin()));
}

Image channelOf(const ReadImage& picture, std::size_t channel)
{
    Image result(picture.image.width, picture.image.height, 1);
    for (std::size_t i = 0; i < result.texels.size(); ++i)
        result.texels[i] = picture.image.texels[i * static_cast<std::size_t>(picture.image.channels) + channel];
    return result;
}

// sRGB codes with straight alpha become premultiplied, linear light.
void linearise(ComparedPicture& picture)
{
    for (std::size_t i = 0; i < picture.linear.texels.size(); ++i) {
        const float alpha = picture.alpha.texels.empty() ? 1.0f : picture.alpha.texels[i / 3];
        picture.linear.texels[i] = srgbDecode(picture.linear.texels[i]) * alpha;
    }
}

void warnOfOtherChannels(const ReadImage& picture, const std::string& path)
{
    std::string others;
    for (const std::string& name : picture.channelNames)
        if (name.find('.') != std::string::npos)
            others += (others.empty() ? "" : ", ") + name;
    if (!others.empty())
        logWarning(path + ": not compared: " + others);
}

ComparedPicture readPicture(const std::string& path)
{
    const ReadImage picture = readImage(path);
    warnOfOtherChannels(picture, path);
    ComparedPicture compared{.linear = colorOf(picture, path), .alpha = {}, .displayReferred = picture.displayReferred};
    if (const auto channel = alphaChannel(picture))
        compared.alpha = channelOf(picture, *channel);
    if (picture.displayReferred)
        linearise(compared);
    return compared;
}

void checkAlike(const ComparedPicture& reference, const ComparedPicture& test, const Options& options)
{
    const auto size = [](const Image& image) { return fmt::format("{}x{}", image.width, image.height); };
    if (size(reference.linear) != size(test.linear))
        throw inputError(options.test, "",
                         "is " + size(test.linear) + ", and " + options.reference + " is " + size(reference.linear),
                         "draw both at one size");
    if (reference.displayReferred != test.displayReferred)
        throw inputError(options.test, "",
                         std::string(test.displayReferred ? "is display-referred" : "is scene-linear") + ", and " +
                             options.reference + " is not",
                         "compare PNG, JPEG or WebP with each other, and EXR or HDR");
}

void checkHeatMapName(const std::string& path)
{
    if (!path.empty() && imageFormatOf(path) != ImageFormat::png)
        throw usageError("--heat-map " + path + ": the heat map is a PNG", "name it .png");
}

void writeHeatMap(const std::string& path, const PictureComparison& comparison)
{
    const std::vector<std::byte> bytes = encodePng(heatMap(comparison.flipMap), 8);
    if (path == "-")
        writeStandardOutput(bytes);
    else
        writeFile(path, bytes);
}

std::string report(const PictureComparison& comparison, bool displayReferred)
{
    std::string text;
    for (const QuantityName& name : kQuantities)
        text += fmt::format("{:<24} {:.6g}\n", name.text, valueOf(name.quantity, comparison));
    const ImageMetrics& metrics = comparison.metrics;
    text +=
        fmt::format("{:<24} column {}, row {} from the top left\n", "worst pixel at", metrics.worst.x, metrics.worst.y);
    text += fmt::format("{:<24} {}\n", "non-finite in reference", metrics.nonFiniteReference);
    text += fmt::format("{:<24} {}\n", "FLIP", displayReferred ? "LDR" : "HDR");
    return text;
}

std::vector<std::string> exceeded(const Options& options, const PictureComparison& comparison)
{
    std::vector<std::string> problems;
    for (std::size_t i = 0; i < std::size(kQuantities); ++i) {
        const double value = valueOf(kQuantities[i].quantity, comparison);
        if (options.limits[i] && !(value <= *options.limits[i])) // a NaN exceeds every limit
            problems.push_back(
                fmt::format("{} {:.6g} is above {:.6g}", kQuantities[i].text, value, *options.limits[i]));
    }
    return problems;
}

Json result(const Options& options, const PictureComparison& comparison, bool displayReferred, bool passed)
{
    Json::Object object = {{"reference", options.reference}, {"test", options.test}};
    object.emplace_back("width", comparison.flipMap.width);
    object.emplace_back("height", comparison.flipMap.height);
    object.emplace_back("flip_kind", displayReferred ? "LDR" : "HDR");
    Json::Object limits;
    for (std::size_t i = 0; i < std::size(kQuantities); ++i) {
        std::string key = kQuantities[i].option;
        std::replace(key.begin(), key.end(), '-', '_');
        if (kQuantities[i].quantity == Quantity::nonFinite)
            object.emplace_back(key, comparison.metrics.nonFiniteTest);
        else
            object.emplace_back(key, valueOf(kQuantities[i].quantity, comparison));
        if (options.limits[i])
            limits.emplace_back(key, *options.limits[i]);
    }
    const ImageMetrics& metrics = comparison.metrics;
    object.emplace_back("worst_pixel", Json::Object{{"x", metrics.worst.x}, {"y", metrics.worst.y}});
    object.emplace_back("mean_error", metrics.meanError);
    object.emplace_back("non_finite_reference", metrics.nonFiniteReference);
    object.emplace_back("limits", std::move(limits));
    object.emplace_back("passed", passed);
    return object;
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    checkHeatMapName(options.heatMap);
    if (global.json == "-" && options.heatMap == "-")
        throw usageError("--heat-map and --json both name standard output", "give one of them a file");
    const ComparedPicture reference = readPicture(options.reference), test = readPicture(options.test);
    checkAlike(reference, test, options);
    const PictureComparison comparison = comparePictures(reference, test);
    const std::vector<std::string> problems = exceeded(options, comparison);
    // Standard output belongs to what was asked to go there.
    if (!global.quiet && global.json != "-" && options.heatMap != "-")
        writeStandardOutput(report(comparison, test.displayReferred));
    writeJson(global.json, result(options, comparison, test.displayReferred, problems.empty()));
    if (!options.heatMap.empty())
        writeHeatMap(options.heatMap, comparison);
    if (!problems.empty())
        throw Error(ExitCode::checkFailed, fmt::format("{}: {}", options.test, fmt::join(problems, ", ")));
    return ExitCode::success;
}

} // namespace

Command compareCommand()
{
    return makeCommand<Options>("compare", "Measure how far a picture lies from a reference", declare, run);
}

} // namespace torrance
