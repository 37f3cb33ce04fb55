// A picture drawn until its certificate says that it is within a tolerance.
#pragma once

#include "plan/tolerance_plan.h"
#include "scene/pixel_box.h"
#include "study/certificate.h"

#include <functional>

namespace torrance {

/// After the first picture, methods go up this many times at most; the last time to the nearest there are, so that what
/// is not within then is out of reach of all of them.
inline constexpr int kMostSteps = 4;
/// Where values are within kAim of the tolerance (with the last methods, within it) and an interval is not, the same
/// picture is compared at four times the pixels, up to this many: a few bad pixels widen the interval more than a
/// dearer method would narrow it.
inline constexpr int kMostToleranceCertified = 32768;
inline constexpr int kMorePixels = 4;
/// Of the tolerance: what the noise of the truths may be (CertificateRequest::noise). It then widens the interval's
/// upper end by a fifth of the tolerance at most, where it adds to the error at all.
inline constexpr double kToleranceNoise = 0.5;

struct ToleranceTrial
{
    std::vector<Rung> rungs; // what was taken of each ladder of the plan
    /// Materials that had cheaper methods, of an earlier trial: numbers as Settings::ofMaterials has them.
    std::vector<int> cheaper;
    Bounded mean, percentile99;
};

struct ToleranceResult
{
    TolerancePlan plan;
    Settings settings; // of the last picture
    std::vector<ToleranceTrial> trials;
    Certificate certificate;
    bool holds = false;
    std::string obstacle; // what stands in the way, where it does not
};

/// True where the upper ends of the intervals are within: with 95 % confidence, so is the picture.
bool isWithin(const Tolerance& tolerance, const ErrorNumbers& error);

struct ToleranceTask
{
    const Scene& scene;
    const Camera& camera;
    const Settings& asked;
    const MethodTable& table;
    Tolerance tolerance;
    std::vector<brdf::Slot> fixed = {}; // slots whose methods were asked for by name
    bool byMaterial = true; // when a picture is within, materials that can do with methods of an earlier trial get them
    CertificateRequest request = {};
    Checkpoint checkpoint = {};
};

/// What the device writes with these settings: everywhere, or, with `only`, at least in these boxes, as in the whole
/// picture. Valid until the next call.
using DrawPicture = std::function<const Image&(const Settings&, std::span<const PixelBox> only)>;

/// Methods are tried where the certificate looks; what is found is drawn whole after its trial, with the same settings.
/// Where nothing is covered, the certificate's `covered` is 0 and nothing holds. Throws as requireCertifiable, and what
/// `draw` throws.
ToleranceResult drawWithin(const ToleranceTask& task, const DrawPicture& draw);

/// What was chosen and why, what was tried and how far off it was, a line each: for people.
std::vector<std::string> toleranceLines(const ToleranceResult& result);

} // namespace torrance
