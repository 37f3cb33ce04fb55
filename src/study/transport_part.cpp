#include "study/transport_part.h"

#include "core/error.h"
#include "core/parallel.h"
#include "study/error_numbers.h"

#include <string>

namespace torrance {

void requireTraceable(const Settings& settings)
{
    if (settings.methods.model->id == "phong")
        throw usageError("--certify=transport: the preset " + std::string(settings.methods.id) +
                             " is no BRDF, so that no light goes on from one surface to another",
                         "leave transport out");
}

TransportPart transportPart(const Scene& scene, const Camera& camera, const Settings& settings,
                            const CertificateRequest& request, const CertifiedSample& sample)
{
    ReferenceSettings traced = exactSettings(settings, request);
    traced.transport = true;
    traced.seed = request.seed + 3; // independent of the light without, and of the other parts
    const PixelEstimator estimator(scene, camera, traced);
    std::vector<PixelError> own(sample.pixels.size()), both(sample.pixels.size());
    parallelFor(sample.pixels.size(), 1, [&](std::size_t i) {
        const CoveredPixel& pixel = sample.pixels[i];
        const Replicates truth = estimator.replicates(pixel.x, pixel.y, traced.directions, traced.seed).colors;
        Replicates differences;
        for (std::size_t r = 0; r < kReplicates; ++r)
            differences.values[r] = sample.own[i].values[r] - truth.values[r];
        own[i] = pixelError(differences, truth);
        both[i] = pixelError(sample.drawn[i], truth);
    });
    const double meanNorm = meanNormOf(sample.strata, own);
    return {errorNumbers(sample.strata, own, meanNorm), errorNumbers(sample.strata, both, meanNorm)};
}

} // namespace torrance
