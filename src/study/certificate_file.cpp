#include "study/certificate_file.h"

#include "core/error.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <sstream>

namespace torrance {
namespace {

// The number changes with what follows, and with how truths are drawn: verify draws them again.
constexpr const char* kFormat = "torrance certificate 2";

Json::Array colorJson(const dvec3& c)
{
    return {c.r, c.g, c.b};
}

Json numbersJson(const ErrorNumbers& numbers)
{
    return Json::Object{{"mean", boundedJson(numbers.mean)},
                        {"median", boundedJson(numbers.median)},
                        {"percentile_99", boundedJson(numbers.percentile99)}};
}

Json worstJson(const Certificate& certificate)
{
    const WorstFound& worst = *certificate.worst;
    return Json::Object{
        {"error", boundedJson(worst.error)},
        {"x", worst.x},
        {"y", worst.y},
        {"material", worst.material},
        {"chosen", worst.why},
        {"drawn", colorJson(worst.drawn)},
        {"exact", colorJson(worst.exact)},
        {"cause",
         Json::Object{{"slot", worst.cause.slot}, {"method", worst.cause.method}, {"share", worst.cause.share}}},
        {"at_most_worse", certificate.worseShare}};
}

Json methodsJson(const brdf::Preset& methods)
{
    Json::Object object;
    for (const brdf::Slot slot : brdf::allSlots())
        if (const brdf::Method* method = methods[slot])
            object.emplace_back(std::string(brdf::slotName(slot)), std::string(method->id));
    return object;
}

Json::Array ofMaterialsJson(const Settings& settings)
{
    Json::Array texts;
    for (const auto& [material, own] : settings.ofMaterials)
        texts.emplace_back(materialMethodsText(material, own));
    return texts;
}

Json::Array textsJson(const std::vector<std::string>& texts)
{
    return {texts.begin(), texts.end()};
}

/// A line each: x y r g b, the shortest digits that read back to the same floats.
Json::Array pixelsJson(const std::vector<LookedPixel>& pixels)
{
    Json::Array lines;
    for (const LookedPixel& p : pixels)
        lines.emplace_back(fmt::format("{} {} {} {} {}", p.x, p.y, static_cast<float>(p.drawn.r),
                                       static_cast<float>(p.drawn.g), static_cast<float>(p.drawn.b)));
    return lines;
}

LookedPixel pixelOf(const JsonView& view, int width, int height)
{
    std::istringstream line(view.text());
    LookedPixel pixel;
    std::string r, g, b;
    if (!(line >> pixel.x >> pixel.y >> r >> g >> b) || pixel.x < 0 || pixel.y < 0 || pixel.x >= width ||
        pixel.y >= height)
        view.refuse("is no pixel of the picture");
    const auto number = [&](const std::string& text) { // nan and inf, too
        char* end = nullptr;
        const float value = std::strtof(text.c_str(), &end);
        if (*end != '\0')
            view.refuse("is no pixel of the picture");
        return static_cast<double>(value);
    };
    pixel.drawn = {number(r), number(g), number(b)};
    return pixel;
}

int wholeNumber(const JsonView& view, double least, double most)
{
    const double number = view.number();
    if (!(number >= least && number <= most) || number != std::floor(number))
        view.refuse(fmt::format("must be a whole number from {} to {}", least, most));
    return static_cast<int>(number);
}

std::optional<double> noiseOf(const JsonView& view)
{
    const double noise = view.numberOr(std::numeric_limits<double>::quiet_NaN());
    if (std::isnan(noise))
        return std::nullopt;
    if (!(noise >= kLeastNoise && noise <= kMostNoise))
        view.refuse(fmt::format("must be from {} to {}", kLeastNoise, kMostNoise));
    return noise;
}

void readNumbers(const JsonView& view, const std::string& name, ReadCertificate& read)
{
    for (const char* which : {"mean", "median", "percentile_99"})
        for (const char* part : {"value", "low", "high"})
            read.numbers.emplace_back(name + " " + which + " " + part, view.member(which).member(part).numberOr(
                                                                           std::numeric_limits<double>::quiet_NaN()));
}

void addNumbers(const ErrorNumbers& numbers, const std::string& name, std::vector<std::pair<std::string, double>>& list)
{
    const auto add = [&](const char* which, const Bounded& number) {
        list.emplace_back(name + " " + which + " value", number.value);
        list.emplace_back(name + " " + which + " low", number.low);
        list.emplace_back(name + " " + which + " high", number.high);
    };
    add("mean", numbers.mean);
    add("median", numbers.median);
    add("percentile_99", numbers.percentile99);
}

} // namespace

Json boundedJson(const Bounded& number)
{
    return Json::Object{{"value", number.value}, {"low", number.low}, {"high", number.high}};
}

Json certificateJson(const Certificate& certificate, const CertifiedPicture& picture, const Settings& settings,
                     bool linear)
{
    const CertificateRequest& request = certificate.request;
    Json::Object object = {
        {"format", kFormat},
        {"program", picture.program},
        {"image", Json::Object{{"file", picture.file},
                               {"hash", picture.hash},
                               {"hash_of", linear ? "the pixels' R, G, B, A as floats" : "the file's bytes"},
                               {"width", settings.width},
                               {"height", settings.height},
                               {"non_finite_pixels", certificate.nonFinite}}},
        {"scene", Json::Object{{"hash", picture.sceneHash}, {"arguments", textsJson(picture.arguments)}}},
        {"plan", Json::Object{{"hash", picture.planHash},
                              {"preset", std::string(settings.methods.id)},
                              {"methods", methodsJson(settings.methods)},
                              {"of_materials", ofMaterialsJson(settings)},
                              {"path", picture.path},
                              {"samples", settings.samples}}},
        {"device", picture.device},
        {"driver", picture.driver},
        {"yardstick", "model"},
        {"sample", Json::Object{{"covered_pixels", certificate.covered},
                                {"compared", certificate.compared},
                                {"forced", certificate.forced},
                                {"asked", request.pixels},
                                {"sampling", request.sampling},
                                {"transport", request.transport},
                                {"seed", static_cast<std::int64_t>(request.seed)},
                                {"directions", request.directions},
                                {"asked_noise", request.noise ? Json(*request.noise) : Json()},
                                {"mean_norm", certificate.meanNorm},
                                {"noise", certificate.noise},
                                {"confidence", 0.95}}},
        {"shading", numbersJson(certificate.shading)}};
    if (certificate.worst)
        object.emplace_back("worst", worstJson(certificate));
    if (certificate.sampling)
        object.emplace_back("sampling", numbersJson(*certificate.sampling));
    if (certificate.both)
        object.emplace_back("shading_and_sampling", numbersJson(*certificate.both));
    if (certificate.transport)
        object.emplace_back("transport", numbersJson(*certificate.transport));
    if (certificate.shadingAndTransport)
        object.emplace_back("shading_and_transport", numbersJson(*certificate.shadingAndTransport));
    if (!std::holds_alternative<std::nullptr_t>(picture.tolerance.value))
        object.emplace_back("tolerance", picture.tolerance);
    object.emplace_back("not_vouched_for", textsJson(certificate.unvouched));
    if (!linear)
        object.emplace_back("pixels", pixelsJson(certificate.pixels));
    return object;
}

std::vector<std::pair<std::string, double>> comparedNumbers(const Certificate& certificate)
{
    std::vector<std::pair<std::string, double>> numbers = {
        {"covered pixels", double(certificate.covered)},
        {"compared pixels", double(certificate.compared)},
        {"worst error", certificate.worst ? certificate.worst->error.value : 0.0}};
    addNumbers(certificate.shading, "shading", numbers);
    if (certificate.sampling)
        addNumbers(*certificate.sampling, "sampling", numbers);
    if (certificate.both)
        addNumbers(*certificate.both, "shading_and_sampling", numbers);
    if (certificate.transport)
        addNumbers(*certificate.transport, "transport", numbers);
    if (certificate.shadingAndTransport)
        addNumbers(*certificate.shadingAndTransport, "shading_and_transport", numbers);
    return numbers;
}

ReadCertificate readCertificate(std::string_view text, const std::string& file)
{
    const Json json = parseJson(text, file);
    const JsonView view(json, file);
    if (view.member("format").text() != kFormat)
        view.member("format").refuse(std::string("is not \"") + kFormat + "\": made by another version");
    ReadCertificate read;
    const JsonView image = view.member("image"), scene = view.member("scene"), sample = view.member("sample");
    constexpr double kMostSide = 32768, kMostDirections = 1 << 24;
    read.width = wholeNumber(image.member("width"), 1, kMostSide);
    read.height = wholeNumber(image.member("height"), 1, kMostSide);
    read.nonFinite = image.member("non_finite_pixels").number();
    read.picture.file = image.member("file").text();
    read.picture.hash = image.member("hash").text();
    read.picture.sceneHash = scene.member("hash").text();
    for (const JsonView& argument : scene.member("arguments").elements())
        read.picture.arguments.push_back(argument.text());
    read.picture.planHash = view.member("plan").member("hash").text();
    read.picture.path = view.member("plan").member("path").text();
    read.request.pixels = wholeNumber(sample.member("asked"), kLeastCertified, kMostCertified);
    read.request.directions = wholeNumber(sample.member("directions"), kDirectionsPerRound, kMostDirections);
    if (sample.has("asked_noise"))
        read.request.noise = noiseOf(sample.member("asked_noise"));
    read.request.seed = static_cast<std::uint64_t>(wholeNumber(sample.member("seed"), 0, 1 << 30));
    read.request.sampling = view.has("sampling");
    read.request.transport = view.has("transport");
    read.numbers = {{"covered pixels", sample.member("covered_pixels").number()},
                    {"compared pixels", sample.member("compared").number()},
                    {"worst error", view.member("worst").member("error").member("value").numberOr(
                                        std::numeric_limits<double>::quiet_NaN())}};
    readNumbers(view.member("shading"), "shading", read);
    if (read.request.sampling) {
        readNumbers(view.member("sampling"), "sampling", read);
        readNumbers(view.member("shading_and_sampling"), "shading_and_sampling", read);
    }
    if (read.request.transport) {
        readNumbers(view.member("transport"), "transport", read);
        readNumbers(view.member("shading_and_transport"), "shading_and_transport", read);
    }
    if (view.has("pixels"))
        for (const JsonView& line : view.member("pixels").elements())
            read.pixels.push_back(pixelOf(line, read.width, read.height));
    return read;
}

ContentHash pixelHash(const Image& colors)
{
    ContentHasher hasher;
    hasher.add(colors.width).add(colors.height).add(colors.channels);
    hasher.add(std::as_bytes(std::span(colors.texels)));
    return hasher.finish();
}

std::string certificateFile(const std::string& picture)
{
    return picture + ".certificate.json";
}

} // namespace torrance
