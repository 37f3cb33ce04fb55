#include "study/certificate.h"

#include "brdf/brdf.h"
#include "core/error.h"
#include "core/parallel.h"
#include "measure/image_metrics.h"
#include "plan/level_plan.h"
#include "plan/pixel_sampling_plan.h"
#include "study/error_numbers.h"
#include "study/material_errors.h"
#include "study/pixel_effort.h"
#include "study/surface_survey.h"
#include "study/transport_part.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

/// Places of a pixel per replicate of the part `sampling`: 64 in all.
constexpr int kPlaces = 4;
/// Where directions are dealt out, the first look takes this part of them.
constexpr int kFirstLook = 4;
constexpr std::uint64_t kFirstLookSeed = 3; // seed + 1 is the worst pixel's, + 2 that of the part `sampling`
/// The worst pixel is integrated once more, with this many times the directions.
constexpr int kWorstEffort = 16;

dvec3 colorAt(const Image& image, const CoveredPixel& pixel)
{
    const float* color = image.at(pixel.x, pixel.y);
    return {color[0], color[1], color[2]};
}

std::size_t nonFinitePixels(const Image& image)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.texels.size(); i += static_cast<std::size_t>(image.channels)) {
        bool finite = true;
        for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c)
            finite = finite && std::isfinite(image.texels[i + c]);
        count += finite ? 0 : 1;
    }
    return count;
}

int roundsOf(int directions, int places)
{
    return std::max(1, directions / (places * kDirectionsPerRound)) * kDirectionsPerRound;
}

std::optional<dvec4> backgroundOf(const Settings& settings)
{
    switch (settings.background) {
    case BackgroundKind::color:
        return dvec4(settings.backgroundColor, 1.0);
    case BackgroundKind::transparent:
        return dvec4(0.0);
    case BackgroundKind::environment:
        break;
    }
    return std::nullopt;
}

/// Through some of its surfaces.
bool showsBackground(const Scene& scene)
{
    return std::ranges::any_of(scene.materials,
                               [](const Material& material) { return material.alphaMode == AlphaMode::blend; });
}

std::vector<std::size_t> pixelsOf(const std::vector<PixelStratum>& strata)
{
    std::vector<std::size_t> pixels;
    for (const PixelStratum& stratum : strata)
        pixels.insert(pixels.end(), stratum.drawn.begin(), stratum.drawn.end());
    return pixels;
}

/// Everything that is looked at, with what is known of it: the sample first, the forced pixels after it.
struct Looked
{
    std::vector<PixelStratum> strata;
    std::vector<ForcedPixel> forced;
    std::vector<std::size_t> pixels; // numbers in the list of covered pixels
    std::size_t sampled = 0;
    std::vector<Replicates> truths;
    std::vector<PixelError> errors;

    std::span<const PixelError> sampleErrors() const { return std::span(errors).first(sampled); }
};

void pass(const Checkpoint& checkpoint)
{
    if (checkpoint)
        checkpoint();
}

/// Directions of every pixel of the sample. The first look's estimates are thrown away: a pixel in which it missed a
/// lamp looks even, and would keep its wrong mean.
std::vector<int> effortsOf(const PixelEstimator& estimator, const std::vector<CoveredPixel>& covered,
                           const std::vector<std::size_t>& sample, const CertificateRequest& request, int directions,
                           const Checkpoint& checkpoint)
{
    if (!request.noise)
        return std::vector<int>(sample.size(), directions);
    const int few = std::max(directions / kFirstLook / kDirectionsPerRound, 1) * kDirectionsPerRound;
    std::vector<PixelSpread> spreads(sample.size());
    parallelFor(spreads.size(), 1, [&](std::size_t i) {
        pass(checkpoint);
        const CoveredPixel& pixel = covered[sample[i]];
        const Replicates colors = estimator.replicates(pixel.x, pixel.y, few, request.seed + kFirstLookSeed).colors;
        const PixelError known = pixelError(colors.mean(), colors);
        spreads[i] = {known.norm, known.normVariance * few};
    });
    return directionsFor(spreads, *request.noise, few, kDirectionsPerRound);
}

std::vector<Replicates> integrated(const PixelEstimator& estimator, const std::vector<CoveredPixel>& covered,
                                   const std::vector<std::size_t>& sample, const CertificateRequest& request,
                                   int directions, const Checkpoint& checkpoint)
{
    const std::vector<int> efforts = effortsOf(estimator, covered, sample, request, directions, checkpoint);
    std::vector<Replicates> truths(sample.size());
    parallelFor(truths.size(), 1, [&](std::size_t i) {
        pass(checkpoint);
        const CoveredPixel& pixel = covered[sample[i]];
        truths[i] = estimator.replicates(pixel.x, pixel.y, efforts[i], request.seed).colors;
    });
    return truths;
}

/// The sample and the forced pixels of this picture, which have the plain number of directions: no mean is of them.
Looked lookAt(const PixelEstimator& estimator, const std::vector<CoveredPixel>& covered, const Image& drawn,
              const CertificateRequest& request, int directions, const std::vector<PixelStratum>& strata,
              const std::vector<Replicates>& truths, CertificateParts parts)
{
    Looked looked;
    looked.strata = strata;
    if (parts != CertificateParts::sample)
        looked.forced = forcedPixels(estimator.rays().scene(), covered, drawn, request.seed);
    looked.pixels = pixelsOf(looked.strata);
    looked.sampled = looked.pixels.size();
    for (const ForcedPixel& forced : looked.forced)
        looked.pixels.push_back(forced.pixel);
    looked.truths = truths;
    looked.truths.resize(looked.pixels.size());
    looked.errors.resize(looked.pixels.size());
    parallelFor(looked.pixels.size(), 1, [&](std::size_t i) {
        const CoveredPixel& pixel = covered[looked.pixels[i]];
        if (i >= looked.sampled)
            looked.truths[i] = estimator.replicates(pixel.x, pixel.y, directions, request.seed).colors;
        looked.errors[i] = pixelError(colorAt(drawn, pixel), looked.truths[i]);
    });
    return looked;
}

std::size_t worstOf(const Looked& looked, double meanNorm)
{
    std::size_t worst = 0;
    double most = -1.0;
    for (std::size_t i = 0; i < looked.errors.size(); ++i) {
        const double error = relativeError(looked.errors[i], kPixelFloor * meanNorm).value;
        if (error > most) {
            most = error;
            worst = i;
        }
    }
    return worst;
}

std::string materialNameOf(const Scene& scene, int material)
{
    return material < 0 ? "" : oneLine(scene.materials[static_cast<std::size_t>(material)].name);
}

WorstFound worstFound(const PixelEstimator& estimator, const Settings& settings, const Image& drawn,
                      const Looked& looked, const std::vector<CoveredPixel>& covered, double meanNorm, int directions,
                      std::uint64_t seed)
{
    const std::size_t i = worstOf(looked, meanNorm);
    const CoveredPixel& pixel = covered[looked.pixels[i]];
    const dvec3 color = colorAt(drawn, pixel);
    const Replicates truth = estimator.replicates(pixel.x, pixel.y, kWorstEffort * directions, seed).colors;
    WorstFound worst = {.x = pixel.x,
                        .y = pixel.y,
                        .material = materialNameOf(estimator.rays().scene(), pixel.material),
                        .why = i < looked.sampled ? "drawn at random" : looked.forced[i - looked.sampled].why,
                        .drawn = color,
                        .exact = truth.mean(),
                        .error = relativeError(pixelError(color, truth), kPixelFloor * meanNorm),
                        .cause = {}};
    worst.cause = pixelCause(estimator, settings, pixel.x, pixel.y, color, worst.exact);
    return worst;
}

/// What the truths are known to: over the sample, half the 95 % interval of |c|_1 against |c|_1.
double noiseOf(std::span<const PixelError> errors)
{
    double widths = 0.0, norms = 0.0;
    for (const PixelError& error : errors) {
        widths += kStudent95 * std::sqrt(error.normVariance);
        norms += error.norm;
    }
    return norms > 0.0 ? widths / norms : 0.0;
}

void addSamplingPart(const Scene& scene, const Camera& camera, const Settings& settings, const Image& drawn,
                     const Looked& looked, const std::vector<CoveredPixel>& covered, Certificate& certificate)
{
    ReferenceSettings whole = exactSettings(settings, certificate.request);
    whole.levelBias = std::nullopt; // the mean over the pixel is taken of the finest texels
    whole.seed = certificate.request.seed + 2;
    const PixelEstimator estimator(scene, camera, whole);
    const int turns = std::max(1, certificate.request.directions / (kPlaces * kDirectionsPerRound));
    std::vector<PixelError> own(looked.sampled), both(looked.sampled);
    parallelFor(looked.sampled, 1, [&](std::size_t i) {
        const CoveredPixel& pixel = covered[looked.pixels[i]];
        const Replicates mean = estimator.wholePixel(pixel.x, pixel.y, kPlaces, turns).colors;
        Replicates differences;
        for (std::size_t r = 0; r < kReplicates; ++r)
            differences.values[r] = looked.truths[i].values[r] - mean.values[r];
        own[i] = pixelError(differences, mean);
        both[i] = pixelError(colorAt(drawn, pixel), mean);
    });
    const double meanNorm = meanNormOf(looked.strata, own);
    certificate.sampling = errorNumbers(looked.strata, own, meanNorm);
    certificate.both = errorNumbers(looked.strata, both, meanNorm);
}

void addTransportPart(const Scene& scene, const Camera& camera, const Settings& settings, const Image& drawn,
                      const Looked& looked, const std::vector<CoveredPixel>& covered, Certificate& certificate)
{
    CertifiedSample sample = {looked.strata, {}, std::span(looked.truths).first(looked.sampled), {}};
    for (std::size_t i = 0; i < looked.sampled; ++i) {
        sample.pixels.push_back(covered[looked.pixels[i]]);
        sample.drawn.push_back(colorAt(drawn, sample.pixels.back()));
    }
    const TransportPart part = transportPart(scene, camera, settings, certificate.request, sample);
    certificate.transport = part.transport;
    certificate.shadingAndTransport = part.both;
}

} // namespace

ReferenceSettings exactSettings(const Settings& settings, const CertificateRequest& request)
{
    ReferenceSettings exact;
    exact.methods = settings.methods;
    exact.width = settings.width;
    exact.height = settings.height;
    exact.pixelSamples = settings.samples;
    exact.directions = roundsOf(request.directions, settings.samples);
    exact.background = backgroundOf(settings);
    exact.seed = request.seed;
    exact.levelBias = levelBias(settings);
    return exact;
}

void requireCertifiable(const Scene& scene, const Settings& settings)
{
    if (settings.view)
        throw usageError("--certify is of a picture, and --view draws a term of it", "leave one of them out");
    if (shadesOncePerPixel(settings))
        throw usageError("--certify compares what is shaded, and --pixel-sampling reconstructed mixes pixels at edges",
                         "certify --samples 1, which shades the same");
    if (settings.backgroundBlur > 0.0 && (settings.samples > 1 || showsBackground(scene)))
        throw usageError("--certify has no exact value of a blurred background, which pixels of surfaces show here",
                         "leave --background-blur out: all else is the same");
    brdf::requireWholeBrdf(settings.methods);
    if (settings.methods.model->id == "phong" && scene.environment)
        throw usageError("--certify: the preset " + std::string(settings.methods.id) +
                             " is no BRDF, so that light from an environment has no integral",
                         "leave the environment out: --environment none");
}

namespace {

const Settings& requiredCertifiable(const Scene& scene, const Settings& settings, const CertificateRequest& request)
{
    requireCertifiable(scene, settings);
    if (settings.backgroundBlur > 0.0 && (request.sampling || request.transport))
        throw usageError("--certify=sampling and =transport have no exact value of a blurred background",
                         "leave --background-blur out");
    if (request.transport)
        requireTraceable(settings);
    return settings;
}

} // namespace

Certifier::Certifier(const Scene& s, const Camera& c, const Settings& settings, const CertificateRequest& r,
                     const Checkpoint& checkpoint)
    : scene(s), camera(c), request(r), asked(requiredCertifiable(s, settings, r)), exact(exactSettings(settings, r)),
      estimator(s, c, exact), covered(coveredPixels(estimator, settings.width, settings.height)),
      strata(drawSample(covered.size(), static_cast<std::size_t>(r.pixels), r.seed)), sample(pixelsOf(strata)),
      truths(integrated(estimator, covered, sample, r, exact.directions, checkpoint))
{
}

std::vector<CoveredPixel> Certifier::sampled() const
{
    std::vector<CoveredPixel> pixels;
    for (const std::size_t i : sample)
        pixels.push_back(covered[i]);
    return pixels;
}

std::vector<SeenSurface> Certifier::surfaces() const
{
    return surveySurfaces(estimator, asked.methods, sampled());
}

Certificate Certifier::judge(const Settings& settings, const Image& drawn, CertificateParts parts) const
{
    Certificate certificate;
    certificate.request = request;
    certificate.covered = covered.size();
    certificate.nonFinite = nonFinitePixels(drawn);
    if (covered.empty())
        return certificate;
    const Looked looked = lookAt(estimator, covered, drawn, request, exact.directions, strata, truths, parts);
    certificate.compared = looked.sampled;
    certificate.forced = looked.forced.size();
    certificate.meanNorm = meanNormOf(looked.strata, looked.sampleErrors());
    certificate.noise = noiseOf(looked.sampleErrors());
    certificate.shading = errorNumbers(looked.strata, looked.sampleErrors(), certificate.meanNorm);
    certificate.materials =
        materialErrors(looked.strata, sampled(), looked.sampleErrors(), static_cast<int>(scene.materials.size()));
    certificate.worst = worstFound(estimator, settings, drawn, looked, covered, certificate.meanNorm, exact.directions,
                                   request.seed + 1);
    if (looked.sampled < covered.size())
        certificate.worseShare = 1.0 - std::pow(0.05, 1.0 / static_cast<double>(looked.sampled));
    const bool all = parts == CertificateParts::all;
    if (all && request.sampling)
        addSamplingPart(scene, camera, settings, drawn, looked, covered, certificate);
    if (all && request.transport)
        addTransportPart(scene, camera, settings, drawn, looked, covered, certificate);
    for (const std::size_t pixel : looked.pixels)
        certificate.pixels.push_back({covered[pixel].x, covered[pixel].y, colorAt(drawn, covered[pixel])});
    std::vector<dvec2> places;
    for (std::size_t i = 0; i < looked.sampled; ++i)
        places.emplace_back(certificate.pixels[i].x + 0.5, certificate.pixels[i].y + 0.5);
    certificate.unvouched = unvouchedEffects(estimator, all && request.sampling, all && request.transport, places);
    return certificate;
}

Certificate certify(const Scene& scene, const Camera& camera, const Settings& settings, const Image& drawn,
                    const CertificateRequest& request)
{
    return Certifier(scene, camera, settings, request).judge(settings, drawn, CertificateParts::all);
}

} // namespace torrance
