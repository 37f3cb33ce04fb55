// How wrong a picture is: what the device wrote, held against the exact light of some of its pixels.
#pragma once

#include "image/image.h"
#include "plan/material_choice.h"
#include "plan/method_ladder.h"
#include "plan/settings.h"
#include "reference/pixel_estimate.h"
#include "scene/scene.h"
#include "study/pixel_cause.h"
#include "study/pixel_error.h"
#include "study/pixel_sample.h"
#include "study/unvouched.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace torrance {

/// Sample pixels where nothing else is asked for: the 3/N rule then speaks of 0.6 % of the pixels.
inline constexpr int kDefaultCertified = 512;
/// Below this many no interval says much.
inline constexpr int kLeastCertified = 16;
inline constexpr int kMostCertified = 1 << 20;

struct CertificateRequest
{
    int pixels = kDefaultCertified;
    bool sampling = false;  // the part of pixel and texture filtering, too
    bool transport = false; // that of shadows and interreflection, too
    std::uint64_t seed = 0;
    int directions = 1024; // of a pixel, per light that is no point: about what keeps the truth's noise below the
                           // sample's (docs/certificate.md)
    /// None: `directions` each. Else a first look with fewer finds out where noise is, and directions are dealt out so
    /// that the truths are known to this share of |c|_1, over the sample (pixel_effort.h).
    std::optional<double> noise = {};
};

/// What can be asked for: below, kMostDirectionsInAll is the end in any case; above, it asks for nothing.
inline constexpr double kLeastNoise = 1e-5;
inline constexpr double kMostNoise = 0.5;

/// A pixel that was looked at, and what the device wrote there.
struct LookedPixel
{
    int x = 0, y = 0;
    dvec3 drawn = dvec3(0.0);
};

/// Over the covered pixels, as DESIGN.md defines them: mean = sum |d - c|_1 / sum |c|_1; of a pixel, |d - c|_1 / (|c|_1
/// + 1 % of the mean |c|_1).
struct ErrorNumbers
{
    Bounded mean, median, percentile99;
};

struct WorstFound
{
    int x = 0, y = 0;
    std::string material;
    std::string why; // it was looked at: "drawn at random", "the brightest", ...
    dvec3 drawn = dvec3(0.0), exact = dvec3(0.0);
    Bounded error; // from directions of its own: the greatest of many estimates by itself is too great
    PixelCause cause;
};

struct Certificate
{
    CertificateRequest request;
    std::size_t covered = 0;   // pixels whose centre sees a surface
    std::size_t compared = 0;  // of them, drawn at random
    std::size_t forced = 0;    // and looked at beside them; none of CertificateParts::sample
    std::size_t nonFinite = 0; // pixels with a NaN or Inf, in the whole picture
    double meanNorm = 0.0;     // |c|_1
    double noise = 0.0; // half the 95 % interval of the truths' |c|_1, mean over mean |c|_1: what one pixel is known to
    ErrorNumbers shading;
    MaterialErrors materials;        // of the sample: material_errors.h
    std::optional<WorstFound> worst; // none where nothing is covered
    /// At 95 %: at most this share of the covered pixels is worse than the worst found. 1 - 0.05^(1/N), about 3/N
    /// (Hanley & Lippman-Hand, If Nothing Goes Wrong, Is Everything All Right?, 1983); 0 where all were compared.
    double worseShare = 0.0;
    std::optional<ErrorNumbers> sampling;  // the pixel's own exact light against the exact mean over the pixel
    std::optional<ErrorNumbers> both;      // what was drawn against that mean
    std::optional<ErrorNumbers> transport; // the pixel's own exact light against the path-traced one
    std::optional<ErrorNumbers> shadingAndTransport; // what was drawn against the path-traced light
    std::vector<std::string> unvouched;
    std::vector<LookedPixel> pixels; // those drawn at random, then the forced ones
};

enum class CertificateParts
{
    sample, // shading, by the pixels drawn at random alone: the picture may be nothing elsewhere
    all,    // that the request asks for, of the whole picture
};

/// Called before each pixel whose truth is computed, from any thread: what it throws ends the work.
using Checkpoint = std::function<void()>;

/// Pictures of one scene, certified one after the other: what they are compared with is computed once.
class Certifier
{
public:
    /// Keeps references to scene and camera. Throws as requireCertifiable. The methods in `settings` are the model that
    /// is asked for; those that stand in for integrals may differ from picture to picture, all else may not.
    Certifier(const Scene& scene, const Camera& camera, const Settings& settings, const CertificateRequest& request,
              const Checkpoint& checkpoint = {});

    /// As certify, of a picture drawn with these settings.
    Certificate judge(const Settings& settings, const Image& drawn, CertificateParts parts) const;

    /// Those that are drawn at random of all that see a surface.
    std::vector<CoveredPixel> sampled() const;

    /// What the pixels that are drawn at random see (surface_survey.h). Empty where nothing is covered.
    std::vector<SeenSurface> surfaces() const;

private:
    const Scene& scene;
    const Camera& camera;
    CertificateRequest request;
    Settings asked;
    ReferenceSettings exact;
    PixelEstimator estimator;
    std::vector<CoveredPixel> covered;
    std::vector<PixelStratum> strata;
    std::vector<std::size_t> sample; // numbers in `covered`
    std::vector<Replicates> truths;  // of the sample
};

/// `drawn` is what the device wrote: RGBA, scene-linear, premultiplied, drawn with these settings. A pure function of
/// its arguments. Throws Error (usage) for what has no exact integral (a view, methods without a BRDF).
Certificate certify(const Scene& scene, const Camera& camera, const Settings& settings, const Image& drawn,
                    const CertificateRequest& request);

/// That Error, before anything is drawn.
void requireCertifiable(const Scene& scene, const Settings& settings);

/// The exact integration of a picture with these settings: at its own places and texture levels.
ReferenceSettings exactSettings(const Settings& settings, const CertificateRequest& request);

} // namespace torrance
