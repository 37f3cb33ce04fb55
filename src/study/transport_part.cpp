#include "study/transport_part.h"

#include "core/parallel.h"
#include "study/error_numbers.h"

namespace torrance {

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
