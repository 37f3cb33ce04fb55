#include "app/command_verify.h"

#include "app/certify.h"
#include "app/environment_option.h"
#include "app/lit_scene.h"
#include "app/phases.h"
#include "core/error.h"
#include "core/log.h"
#include "core/read_file.h"
#include "core/standard_output.h"
#include "files/image_read.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace torrance {
namespace {

struct Options
{
    std::string image;
    std::string certificate;
    std::string model;
    std::string environment;
};

/// Two computations of one certificate agree to this, relatively: the last digits of a processor family's
/// mathematical library, carried through a sum. A pixel that changed moves the numbers by more than 1e-4 of them.
constexpr double kSameNumber = 1e-6;

void declare(CLI::App& app, Options& o)
{
    app.add_option("image", o.image, "The picture that was certified")->type_name("IMAGE")->required();
    app.add_option("--certificate", o.certificate,
                   "Its certificate, instead of IMAGE.certificate.json or what the EXR's header holds")
        ->type_name("FILE");
    app.add_option("--model", o.model, "Where the scene's file lies now")->type_name("FILE");
    app.add_option("-e,--environment", o.environment, "Where the environment's file lies now")->type_name("FILE");
}

struct CertificateText
{
    std::string file; // that it was read from
    std::string text;
};

CertificateText textOf(const Options& o, std::span<const std::byte> image)
{
    const auto read = [](const std::string& file) {
        const std::vector<std::byte> bytes = readFile(file);
        return CertificateText{file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}};
    };
    if (!o.certificate.empty())
        return read(o.certificate);
    if (std::filesystem::exists(certificateFile(o.image)))
        return read(certificateFile(o.image));
    if (isExr(image))
        if (auto text = exrAttribute(image, o.image, kCertificateAttribute))
            return {o.image, std::move(*text)};
    throw inputError(o.image, "", "has no certificate beside it" + std::string(isExr(image) ? " or in it" : ""),
                     "name it with --certificate, or draw the picture with --certify");
}

/// R, G, B and A of a picture that holds what the device wrote.
Image colorsOf(const std::string& file)
{
    ReadImage read = readImage(file);
    if (read.image.channels < 4)
        throw inputError(file, "", "has no R, G, B and A", "verify the picture that was certified");
    Image colors(read.image.width, read.image.height, 4);
    for (int y = 0; y < colors.height; ++y)
        for (int x = 0; x < colors.width; ++x)
            std::copy_n(read.image.at(x, y), 4, colors.at(x, y));
    return colors;
}

/// What the device wrote, as far as it is known: the whole picture out of an EXR, the compared pixels otherwise.
Image drawnOf(const Options& o, std::span<const std::byte> bytes, const ReadCertificate& read)
{
    if (isExr(bytes))
        return colorsOf(o.image);
    Image known(read.width, read.height, 4);
    for (const LookedPixel& pixel : read.pixels)
        for (int c = 0; c < 3; ++c)
            known.at(pixel.x, pixel.y)[c] = static_cast<float>(pixel.drawn[c]);
    return known;
}

std::string hashOf(std::span<const std::byte> bytes, const Image& drawn)
{
    return (isExr(bytes) ? pixelHash(drawn) : hashBytes(bytes)).hex();
}

/// The scene of the certificate and how it was drawn.
struct Recorded
{
    RenderOptions options;
    std::string input;
    Settings settings;
    LoadedScene loaded;
    Camera camera;
};

Recorded loadRecorded(const Options& o, const ReadCertificate& read, const std::string& file)
{
    const std::string folder = std::filesystem::path(o.image).parent_path().string();
    Recorded r;
    r.options = optionsOfRecord(read.picture.arguments, folder.empty() ? "." : folder, file);
    if (!o.model.empty()) {
        if (!r.options.scene.primitive.empty())
            throw usageError("--model: the certificate's scene is a primitive", "leave it out");
        r.options.scene.files = {o.model};
    }
    if (!o.environment.empty())
        r.options.environment.name = o.environment;
    r.input = sceneInputs(r.options.scene).front();
    r.settings = renderSettings(r.options);
    if (r.settings.width != read.width || r.settings.height != read.height)
        throw inputError(file, "/image", "has another size than its scene's arguments say",
                         "certify the picture again");
    r.loaded = loadLitScene(r.options.scene, r.options.light, r.settings.methods,
                            loadChosenEnvironment(r.options.environment, r.settings.methods), r.input);
    r.camera = chooseCamera(cameraOptionsFor(r.options.camera, r.input), r.loaded.scene,
                            double(r.settings.width) / r.settings.height);
    return r;
}

bool isSame(double a, double b)
{
    if (!std::isfinite(a) || !std::isfinite(b)) // infinity was written as null, and is read as NaN
        return !std::isfinite(a) && !std::isfinite(b);
    return std::abs(a - b) <= kSameNumber * std::max(std::abs(a), std::abs(b));
}

/// The first number that is another now; empty where all are the same.
std::string difference(const ReadCertificate& read, const Certificate& now)
{
    const auto numbers = comparedNumbers(now);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (!isSame(numbers[i].second, read.numbers[i].second))
            return fmt::format("{} is {:.9g}, and the certificate says {:.9g}", numbers[i].first, numbers[i].second,
                               read.numbers[i].second);
    return "";
}

/// What does not hold; empty where everything does.
std::string problemOf(const Options& o, std::span<const std::byte> bytes, const ReadCertificate& read,
                      const std::string& file, std::optional<Certificate>& now)
{
    const Image drawn = drawnOf(o, bytes, read);
    if (hashOf(bytes, drawn) != read.picture.hash)
        return "the picture is not the one that was certified: its hash differs";
    const Recorded recorded = loadRecorded(o, read, file);
    if (sceneHashOf(recorded.loaded.scene, recorded.camera) != read.picture.sceneHash)
        return "the scene is not the one that was drawn: its hash differs";
    if (hashText(explain(makePlan(recorded.loaded.scene, recorded.settings))).hex() != read.picture.planHash)
        return "this build plans the scene otherwise";
    now = certify(recorded.loaded.scene, recorded.camera, recorded.settings, drawn, read.request);
    return difference(read, *now);
}

ExitCode run(const Options& o, const GlobalOptions& global)
{
    const std::vector<std::byte> bytes = readFile(o.image);
    const CertificateText certificate = textOf(o, bytes);
    const ReadCertificate read = readCertificate(certificate.text, certificate.file);
    std::optional<Certificate> now;
    const std::string problem = problemOf(o, bytes, read, certificate.file, now);
    Json::Object result = {{"image", o.image}, {"certificate", certificate.file}, {"holds", problem.empty()}};
    if (!problem.empty())
        result.emplace_back("problem", problem);
    writeJson(global.json, result);
    if (!problem.empty()) {
        logError(o.image + ": does not hold: " + problem);
        return ExitCode::checkFailed;
    }
    if (global.json != "-")
        writeStandardOutput(o.image + ": holds: " + certificateLine(*now) + "\n");
    return ExitCode::success;
}

} // namespace

Command verifyCommand()
{
    return makeCommand<Options>("verify", "Hold a picture against its certificate", declare, run);
}

} // namespace torrance
