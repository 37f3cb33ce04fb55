// How wrong a picture is for want of shadows and interreflection.
#pragma once

#include "study/certificate.h"
#include "study/pixel_sample.h"

#include <span>

namespace torrance {

/// The pixels that a certificate drew, with what it knows of them.
struct CertifiedSample
{
    std::span<const PixelStratum> strata;
    std::vector<CoveredPixel> pixels; // stratum by stratum, as the rest
    std::span<const Replicates> own;  // their exact light without transport, of the request's seed
    std::vector<dvec3> drawn;
};

struct TransportPart
{
    ErrorNumbers transport; // their exact light without transport, against that with it
    ErrorNumbers both;      // what was drawn, against that with it
};

/// Throws Error (usage) for methods that no light goes on with from one surface to another.
void requireTraceable(const Settings& settings);

/// Paths are traced at the same places of the pixels, with textures at the same levels, as many of a surface as
/// `request` has directions.
TransportPart transportPart(const Scene& scene, const Camera& camera, const Settings& settings,
                            const CertificateRequest& request, const CertifiedSample& sample);

} // namespace torrance
