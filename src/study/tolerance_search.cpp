#include "study/tolerance_search.h"

#include "brdf/environment.h"
#include "plan/light_plan.h"
#include "plan/shading_plan.h"
#include "reference/shade.h"
#include "study/error_numbers.h"
#include "study/filter_ladder.h"

#include <algorithm>
#include <fmt/format.h>

namespace torrance {
namespace {

LadderScene factsOf(const Scene& scene, const Settings& asked)
{
    const ShadingPlan plan = makePlan(scene, asked);
    return {.environment = plan.environmentLight,
            .even = scene.environment && uniformRadiance(*scene.environment).has_value(),
            .lamps = plan.lights.size() + brdf::kMostLampPoints <= kMostLights,
            .spheres = std::ranges::any_of(plan.lights, [](const Light& light) { return light.radius > 0.0; })};
}

/// Values are within this share of the tolerance, an interval is not within, and there are pixels that were not looked
/// at.
bool isOpen(const Tolerance& tolerance, const Certificate& certificate, double share)
{
    const ErrorNumbers& error = certificate.shading;
    const bool within = error.mean.value <= share * tolerance.mean &&
                        (!tolerance.percentile99 || error.percentile99.value <= share * *tolerance.percentile99);
    return certificate.covered > certificate.compared && within && !isWithin(tolerance, error);
}

std::vector<PixelBox> blocksOf(const std::vector<CoveredPixel>& pixels, const Settings& settings)
{
    std::vector<ivec2> places;
    for (const CoveredPixel& pixel : pixels)
        places.emplace_back(pixel.x, pixel.y);
    return blocksAround(places, settings.width, settings.height);
}

std::string obstacleOf(const ToleranceResult& result)
{
    const Tolerance& tolerance = result.plan.tolerance;
    const ErrorNumbers& error = result.certificate.shading;
    const bool ofMean = error.mean.high > tolerance.mean;
    const Bounded& number = ofMean ? error.mean : error.percentile99;
    const double bound = ofMean ? tolerance.mean : tolerance.percentile99.value_or(0.0);
    const std::string what =
        fmt::format("the {} is {}", ofMean ? "mean error" : "99th percentile", boundedText(number));
    if (number.value <= bound)
        return what + ": its interval is too wide, and more pixels (--certify N) or directions (--certify "
                      "noise=SHARE) narrow it";
    const WorstFound& worst = *result.certificate.worst;
    return what + " with the nearest methods there are; at the worst pixel it comes from " +
           (worst.cause.method.empty() ? worst.cause.slot : worst.cause.slot + " " + worst.cause.method);
}

} // namespace

bool isWithin(const Tolerance& tolerance, const ErrorNumbers& error)
{
    return error.mean.high <= tolerance.mean &&
           (!tolerance.percentile99 || error.percentile99.high <= *tolerance.percentile99);
}

ToleranceResult drawWithin(const ToleranceTask& task, const DrawPicture& draw)
{
    CertificateRequest request = task.request;
    if (!request.noise)
        request.noise = std::clamp(kToleranceNoise * task.tolerance.mean, kLeastNoise, kMostNoise);
    std::optional<Certifier> certifier;
    certifier.emplace(task.scene, task.camera, task.asked, request, task.checkpoint);
    const auto drawSample = [&](const Settings& settings) -> const Image& {
        return draw(settings, blocksOf(certifier->sampled(), settings));
    };
    ToleranceResult result;
    const LadderScene facts = factsOf(task.scene, task.asked);
    result.plan =
        planTolerance(task.table, task.tolerance, task.asked.methods, task.fixed, certifier->surfaces(), facts);
    if (std::ranges::find(task.fixed, brdf::Slot::textureFilter) == task.fixed.end())
        if (auto filters =
                filterLadder(task.scene, settingsOf(result.plan, task.asked), certifier->sampled(), drawSample))
            addLadder(result.plan, std::move(*filters), facts);
    for (int step = 0;; ++step) {
        result.settings = settingsOf(result.plan, task.asked);
        const auto look = [&] {
            return certifier->judge(result.settings, drawSample(result.settings), CertificateParts::sample);
        };
        // Of what these methods draw, whether there are others to go on with.
        const auto goOn = [&](const Certificate& certificate) {
            return step < kMostSteps && (step + 1 == kMostSteps ? goNearest(result.plan)
                                                                : stepUp(result.plan, certificate.shading.mean.value,
                                                                         certificate.worst->cause.slot));
        };
        Certificate seen = look();
        const double share = step == kMostSteps || isNearest(result.plan) ? 1.0 : kAim; // a dearer method may do better
        while (isOpen(task.tolerance, seen, share) && request.pixels * kMorePixels <= kMostToleranceCertified) {
            request.pixels *= kMorePixels;
            certifier.emplace(task.scene, task.camera, task.asked, request, task.checkpoint);
            seen = look();
        }
        if (seen.covered > 0) {
            ToleranceTrial trial = {{}, seen.shading.mean, seen.shading.percentile99};
            for (const MethodLadder& ladder : result.plan.ladders)
                trial.rungs.push_back(ladder.taken());
            result.trials.push_back(std::move(trial));
            if (!isWithin(task.tolerance, seen.shading) && goOn(seen))
                continue;
        }
        result.certificate = certifier->judge(result.settings, draw(result.settings, {}), CertificateParts::all);
        if (result.certificate.covered == 0)
            return result;
        result.holds = isWithin(task.tolerance, result.certificate.shading) && result.certificate.nonFinite == 0;
        if (!result.holds && goOn(result.certificate)) // what the sample does not see
            continue;
        if (!result.holds)
            result.obstacle = obstacleOf(result);
        return result;
    }
}

std::vector<std::string> toleranceLines(const ToleranceResult& result)
{
    std::vector<std::string> lines;
    for (const ToleranceTrial& trial : result.trials) {
        std::string methods;
        for (const Rung& rung : trial.rungs)
            methods += (methods.empty() ? "" : ", ") + nameOf(rung);
        lines.push_back("tried " + (methods.empty() ? "as asked" : methods) + ": mean " + boundedText(trial.mean));
    }
    for (const Remark& remark : remarksOf(result.plan))
        lines.push_back(remark.subject + ": " + remark.choice + " (" + remark.reason + ")");
    return lines;
}

} // namespace torrance
