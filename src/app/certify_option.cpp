#include "app/certify_option.h"

#include "app/option_value.h"
#include "core/error.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <sstream>

namespace torrance {
namespace {

constexpr const char* kUsage =
    "it takes a number of pixels, noise=SHARE, sampling, transport: --certify=512,noise=1%,sampling,transport";

int pixelsOf(const std::string& text)
{
    int pixels = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), pixels);
    const bool isNumber = problem != std::errc::invalid_argument && end == text.data() + text.size();
    if (!isNumber)
        throw usageError("--certify " + text + ": no number of pixels and no part", kUsage);
    if (problem != std::errc() || pixels < kLeastCertified || pixels > kMostCertified)
        throw usageError("--certify " + text + ": must be from " + std::to_string(kLeastCertified) + " to " +
                             std::to_string(kMostCertified) + " pixels",
                         std::to_string(kDefaultCertified) + " is the default");
    return pixels;
}

double noiseOf(const std::string& text)
{
    const double noise = parseShare("--certify=noise", text);
    if (!(noise >= kLeastNoise && noise <= kMostNoise))
        throw usageError("--certify=noise=" + text + ": must be from 0.001 % to 50 %", kUsage);
    return noise;
}

} // namespace

void declareCertifyOption(CLI::App& app, CertifyOption& option)
{
    option.given = app.add_option("--certify", option.text,
                                  "Compare N covered pixels (default 512) with their exact light, and write "
                                  "OUT.certificate.json; noise=SHARE: with as many directions as it takes to know them "
                                  "to this share; sampling: the error of pixel and texture filtering, too; transport: "
                                  "that of missing shadows and interreflection")
                       ->group("Output")
                       ->type_name("N|noise=SHARE|sampling|transport,...")
                       ->expected(0, 1);
}

std::optional<CertificateRequest> chosenCertificate(const CertifyOption& option)
{
    if (!option.given || option.given->count() == 0)
        return std::nullopt;
    CertificateRequest request;
    if (option.text.ends_with(','))
        throw usageError("--certify " + option.text + ": ends in a comma", kUsage);
    std::istringstream parts(option.text);
    for (std::string part; std::getline(parts, part, ',');) {
        if (part == "sampling")
            request.sampling = true;
        else if (part == "transport")
            request.transport = true;
        else if (part.starts_with("noise="))
            request.noise = noiseOf(part.substr(6));
        else
            request.pixels = pixelsOf(part);
    }
    return request;
}

void checkCertifiedOutput(const std::string& output)
{
    if (output == "-")
        throw usageError("--certify: standard output has no place beside it for the certificate",
                         "name a file with --output");
}

} // namespace torrance
