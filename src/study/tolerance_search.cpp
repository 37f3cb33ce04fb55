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

/// Nothing of it is chosen.
bool isUnlit(const Scene& scene, int material)
{
    const auto index = static_cast<std::size_t>(material);
    return index < scene.materials.size() && scene.materials[index].unlit;
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

class Search
{
public:
    Search(const ToleranceTask& t, const DrawPicture& d) : task(t), draw(d), request(t.request)
    {
        if (!request.noise)
            request.noise = std::clamp(kToleranceNoise * task.tolerance.mean, kLeastNoise, kMostNoise);
        prepare();
    }

    ToleranceResult run();

private:
    void prepare() { certifier.emplace(task.scene, task.camera, task.asked, request, task.checkpoint); }

    const Image& drawSample(const Settings& settings) const
    {
        return draw(settings, blocksOf(certifier->sampled(), settings));
    }

    Certificate judgeSample(const Settings& settings) const
    {
        return certifier->judge(settings, drawSample(settings), CertificateParts::sample);
    }

    // Whether the picture, drawn whole, is within; its certificate is the result's.
    bool holdsWhole(const Settings& settings)
    {
        result.settings = settings;
        result.certificate = certifier->judge(settings, draw(settings, {}), CertificateParts::all);
        result.holds = result.certificate.covered > 0 && isWithin(task.tolerance, result.certificate.shading) &&
                       result.certificate.nonFinite == 0;
        return result.holds;
    }

    // The next methods, after step `step` gave this.
    bool goOn(int step, const Certificate& seen)
    {
        if (step == kMostSteps)
            return false;
        return step + 1 == kMostSteps ? goNearest(result.plan)
                                      : stepUp(result.plan, seen.shading.mean.value, seen.worst->cause.slot);
    }

    void plan();
    Certificate look(const Settings& settings, double share);
    void note(const Settings& settings, const Certificate& seen);
    bool holdsByMaterial(const Settings& found);

    const ToleranceTask& task;
    const DrawPicture& draw;
    CertificateRequest request;
    std::optional<Certifier> certifier;
    ToleranceResult result;
    std::vector<MaterialTrial> tried;
    const brdf::Method* triedFilter = nullptr; // of all in `tried`
};

void Search::plan()
{
    const LadderScene facts = factsOf(task.scene, task.asked);
    result.plan =
        planTolerance(task.table, task.tolerance, task.asked.methods, task.fixed, certifier->surfaces(), facts);
    if (std::ranges::find(task.fixed, brdf::Slot::textureFilter) != task.fixed.end())
        return;
    const auto drawn = [&](const Settings& settings) -> const Image& { return drawSample(settings); };
    if (auto filters = filterLadder(task.scene, settingsOf(result.plan, task.asked), certifier->sampled(), drawn))
        addLadder(result.plan, std::move(*filters), facts);
}

Certificate Search::look(const Settings& settings, double share)
{
    Certificate seen = judgeSample(settings);
    while (isOpen(task.tolerance, seen, share) && request.pixels * kMorePixels <= kMostToleranceCertified) {
        request.pixels *= kMorePixels;
        prepare();
        seen = judgeSample(settings);
    }
    return seen;
}

void Search::note(const Settings& settings, const Certificate& seen)
{
    ToleranceTrial trial = {{}, {}, seen.shading.mean, seen.shading.percentile99};
    for (const MethodLadder& ladder : result.plan.ladders)
        trial.rungs.push_back(ladder.taken());
    for (const auto& [material, own] : settings.ofMaterials)
        if (!task.asked.ofMaterials.contains(material))
            trial.cheaper.push_back(material);
    result.trials.push_back(std::move(trial));
}

// Of what was tried with the texture filter that was found: materials do not choose it.
bool Search::holdsByMaterial(const Settings& found)
{
    std::vector<int> free;
    for (const auto& [material, own] : tried.back().errors)
        if (!task.asked.ofMaterials.contains(material) && !isUnlit(task.scene, material))
            free.push_back(material);
    if (!task.byMaterial || tried.size() < 2 || free.size() < 2)
        return false;
    const std::map<int, LightMethods> cheaper =
        cheaperMaterials(tried.back(), std::span(tried).first(tried.size() - 1), free, kAim * task.tolerance.mean);
    if (cheaper.empty())
        return false;
    Settings mixed = found;
    mixed.ofMaterials.insert(cheaper.begin(), cheaper.end());
    const Certificate seen = judgeSample(mixed);
    note(mixed, seen);
    return isWithin(task.tolerance, seen.shading) && holdsWhole(mixed);
}

ToleranceResult Search::run()
{
    plan();
    for (int step = 0;; ++step) {
        const Settings settings = settingsOf(result.plan, task.asked);
        const bool last = step == kMostSteps || isNearest(result.plan);
        const Certificate seen = look(settings, last ? 1.0 : kAim); // a dearer method may do better
        if (seen.covered > 0) {
            note(settings, seen);
            if (triedFilter != settings.methods.textureFilter)
                tried.clear();
            triedFilter = settings.methods.textureFilter;
            tried.push_back({lightMethodsOf(settings), expectedCost(result.plan), seen.materials});
            const bool within = isWithin(task.tolerance, seen.shading);
            if (!within && goOn(step, seen))
                continue;
            if (within && holdsByMaterial(settings))
                return std::move(result);
        }
        if (holdsWhole(settings) || result.certificate.covered == 0)
            return std::move(result);
        if (goOn(step, result.certificate)) // what the sample does not see
            continue;
        result.obstacle = obstacleOf(result);
        return std::move(result);
    }
}

} // namespace

bool isWithin(const Tolerance& tolerance, const ErrorNumbers& error)
{
    return error.mean.high <= tolerance.mean &&
           (!tolerance.percentile99 || error.percentile99.high <= *tolerance.percentile99);
}

ToleranceResult drawWithin(const ToleranceTask& task, const DrawPicture& draw)
{
    return Search(task, draw).run();
}

std::vector<std::string> toleranceLines(const ToleranceResult& result)
{
    std::vector<std::string> lines;
    for (const ToleranceTrial& trial : result.trials) {
        std::string methods;
        for (const Rung& rung : trial.rungs)
            methods += (methods.empty() ? "" : ", ") + nameOf(rung);
        if (!trial.cheaper.empty())
            methods += fmt::format(", {} {} with those of earlier trials", trial.cheaper.size(),
                                   trial.cheaper.size() == 1 ? "material" : "materials");
        lines.push_back("tried " + (methods.empty() ? "as asked" : methods) + ": mean " + boundedText(trial.mean));
    }
    for (const Remark& remark : remarksOf(result.plan))
        lines.push_back(remark.subject + ": " + remark.choice + " (" + remark.reason + ")");
    for (const auto& [material, own] : result.settings.ofMaterials)
        lines.push_back("tolerance, of material " + materialMethodsText(material, own));
    return lines;
}

} // namespace torrance
