// A certificate as JSON, with what it was made from: to be read by people, and to be verified.
#pragma once

#include "core/content_hash.h"
#include "files/json_parse.h"
#include "files/json_write.h"
#include "study/certificate.h"

namespace torrance {

/// What was certified, beside the numbers.
struct CertifiedPicture
{
    std::string file;                   // the picture's name, without its folder
    std::string hash;                   // of what the file holds: certifiedHash
    std::string sceneHash;              // of scene, light and camera
    std::vector<std::string> arguments; // of `render`, that lead to the scene and the settings
    std::string planHash, planText;     // of explain()
    std::string path;                   // on which it was drawn
    std::string device, driver, program;
    Json tolerance; // what was asked for and tried; null where none was
};

/// `linear`: the picture's own file holds what the device wrote, so that the compared pixels need not stand in the
/// certificate.
Json certificateJson(const Certificate& certificate, const CertifiedPicture& picture, const Settings& settings,
                     bool linear);

Json boundedJson(const Bounded& number);

/// The numbers that a verification holds against its own, by name, in the certificate's order.
std::vector<std::pair<std::string, double>> comparedNumbers(const Certificate& certificate);

/// What was read of one.
struct ReadCertificate
{
    CertificateRequest request;
    CertifiedPicture picture;
    std::vector<std::pair<std::string, double>> numbers; // as comparedNumbers; NaN for null
    std::vector<LookedPixel> pixels;                     // where the picture's file does not hold them
    int width = 0, height = 0;
    double nonFinite = 0.0;
};

/// Errors (input) name the file and the place in it of what is missing or of another kind.
ReadCertificate readCertificate(std::string_view text, const std::string& file);

/// Of a picture's R, G, B and A as floats.
ContentHash pixelHash(const Image& colors);

/// The name of the certificate beside a picture.
std::string certificateFile(const std::string& picture);

/// The attribute of an EXR's header that holds it.
inline constexpr const char* kCertificateAttribute = "torranceCertificate";

} // namespace torrance
