// --certify: what of a picture's error is measured.
#pragma once

#include "study/certificate.h"

#include <optional>
#include <string>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace torrance {

struct CertifyOption
{
    std::string text;
    const CLI::Option* given = nullptr; // the option itself, to ask whether it was
};

void declareCertifyOption(CLI::App& app, CertifyOption& option);

/// Nothing where it was not given. Error (usage) for what is neither a number of pixels nor a part, and for the part
/// that does not exist.
std::optional<CertificateRequest> chosenCertificate(const CertifyOption& option);

/// Error (usage) where a certificate has no place beside the picture.
void checkCertifiedOutput(const std::string& output);

} // namespace torrance
