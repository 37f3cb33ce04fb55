// One pixel of the window: what the device drew there, what is exact, and every term of its shading on both sides.
#pragma once

#include "gpu/device.h"
#include "gpu/shader_library.h"
#include "image/image.h"
#include "plan/settings.h"
#include "reference/material_point.h"
#include "study/pixel_cause.h"
#include "study/pixel_error.h"

#include <optional>
#include <string>
#include <vector>

namespace torrance {

/// A method at the pixel's surface, on the device and in double.
struct ProbedTerm
{
    brdf::Slot slot;
    std::string_view id;
    vec3 device = vec3(0.0f);
    dvec3 exact = dvec3(0.0);
};

struct PixelProbe
{
    ivec2 pixel = ivec2(0);
    dvec3 drawn = dvec3(0.0); // scene-linear, premultiplied
    dvec3 exact = dvec3(0.0); // the model that was asked for, integrated exactly
    Bounded error;            // relative: DESIGN's error of a pixel, with the 95 % interval of the truth
    PixelCause cause;         // where the error is more than the truth's noise
    std::string material;     // of the nearest surface
    MaterialPoint surface;
    double NoV = 0.0;
    std::string light; // from where the terms are lit
    std::vector<ProbedTerm> terms;
};

/// Directions of the exact integral, for each light that is no point: four times a certificate's, of one pixel.
inline constexpr int kProbeDirections = 4096;

/// Nothing where the pixel's centre sees no surface. `drawn` is the picture, drawn with these settings. Throws Error
/// (usage) as requireCertifiable (study/certificate.h).
std::optional<PixelProbe> probePixel(const gpu::Device& device, gpu::ShaderLibrary& shaders, const Scene& scene,
                                     const Camera& camera, const Settings& settings, const Image& drawn,
                                     const ivec2& pixel);

} // namespace torrance
