#include "app/certify.h"

#include "app/version.h"
#include "plan/path_plan.h"
#include "scene/scene_hash.h"
#include "study/error_numbers.h"

#include <filesystem>
#include <fmt/format.h>

namespace torrance {
namespace {

std::string worstText(const Certificate& certificate)
{
    const WorstFound& worst = *certificate.worst;
    std::string text = fmt::format("; worst found {} at ({}, {})", percentText(worst.error.value), worst.x, worst.y);
    if (!worst.material.empty())
        text += " on " + worst.material;
    text += ", by " + worst.cause.slot + (worst.cause.method.empty() ? "" : " " + worst.cause.method);
    return text + ", and at most " + percentText(certificate.worseShare) + " of the pixels are worse";
}

} // namespace

std::string sceneHashOf(const Scene& scene, const Camera& camera)
{
    ContentHasher hasher;
    addToHash(hasher, scene);
    addToHash(hasher, camera);
    return hasher.finish().hex();
}

CertifiedPicture describePicture(const RenderOptions& options, const std::string& input, const std::string& output,
                                 const Scene& scene, const Camera& camera, const ShadingPlan& plan)
{
    const std::filesystem::path file = output;
    CertifiedPicture picture;
    picture.file = file.filename().string();
    picture.sceneHash = sceneHashOf(scene, camera);
    picture.arguments =
        recordedArguments(options, input, file.parent_path().empty() ? "." : file.parent_path().string());
    picture.planText = explain(plan);
    picture.planHash = hashText(picture.planText).hex();
    picture.path = nameOf(plan.path);
    picture.program = versionText();
    return picture;
}

std::string certificateLine(const Certificate& certificate)
{
    std::string line = "shading error: mean " + boundedText(certificate.shading.mean) + ", median " +
                       boundedText(certificate.shading.median) + ", 99th percentile " +
                       boundedText(certificate.shading.percentile99);
    if (certificate.worst)
        line += worstText(certificate);
    if (certificate.sampling)
        line += "; sampling error: mean " + boundedText(certificate.sampling->mean) + ", both: mean " +
                boundedText(certificate.both->mean);
    if (certificate.transport)
        line += "; transport error: mean " + boundedText(certificate.transport->mean) + ", with shading: mean " +
                boundedText(certificate.shadingAndTransport->mean);
    if (certificate.nonFinite > 0)
        line += fmt::format("; {} pixels are not finite", certificate.nonFinite);
    return line;
}

} // namespace torrance
