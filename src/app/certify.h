// A picture's certificate, made while it is written and held against it later.
#pragma once

#include "app/render_options.h"
#include "plan/shading_plan.h"
#include "study/certificate_file.h"

namespace torrance {

/// The hash of everything that a picture shows: scene, light, camera.
std::string sceneHashOf(const Scene& scene, const Camera& camera);

/// What was certified of an output that is still to be written; `hash` is left empty where the file's bytes are not
/// known yet.
CertifiedPicture describePicture(const RenderOptions& options, const std::string& input, const std::string& output,
                                 const Scene& scene, const Camera& camera, const ShadingPlan& plan);

/// "mean error 5.1 % (4.7 % to 5.6 %), ...": for people.
std::string certificateLine(const Certificate& certificate);

} // namespace torrance
