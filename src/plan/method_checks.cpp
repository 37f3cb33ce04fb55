#include "plan/method_checks.h"

#include "brdf/environment.h"
#include "core/error.h"
#include "plan/light_plan.h"

#include <string>
#include <string_view>

namespace torrance {
namespace {

// The levels of a source belong to its model, which has no part for any others.
void checkLevels(const ShadingPlan& plan, const brdf::Preset& methods)
{
    if (!plan.environmentLight ||
        methods.environmentSpecular->ownModel == (brdf::isComposed(methods) ? "" : methods.model->id))
        return;
    throw usageError("the model " + std::string(methods.model->id) + " cannot be lit by an environment through " +
                         std::string(methods.environmentSpecular->id),
                     "leave out --environment-specular: each preset has one that goes with its model");
}

// The points of lamps lie behind the lights, and what is left of the radiance is no whole environment.
void checkLamps(const ShadingPlan& plan, const Settings& choice)
{
    const brdf::Preset& methods = choice.methods;
    if (!plan.environmentLight || !brdf::hasLampPoints(*methods.environmentSpecular))
        return;
    if (methods.environmentDiffuse->id == "sampled")
        throw usageError("--environment-specular vndf_lamps takes the lamps out of the radiance that "
                         "--environment-diffuse sampled reads",
                         "use irradiance_cube, which is as exact");
    const std::size_t points = static_cast<std::size_t>(brdf::lampPointCount(choice.environmentSamples));
    if (plan.lights.size() + points > kMostLights)
        throw usageError("--environment-specular vndf_lamps: its " + std::to_string(points) + " points and " +
                             std::to_string(plan.lights.size()) + " lights are more than " +
                             std::to_string(kMostLights),
                         "use vndf_bounded, or leave lights out");
}

// What is tabulated and prefiltered is the lobe of ggx with smith_corr: another lobe would be lit by the wrong one.
void checkLobe(const ShadingPlan& plan)
{
    const brdf::Preset& methods = plan.settings.methods;
    if (!plan.dfgTable || !brdf::isComposed(methods))
        return;
    const std::string_view D = methods.distribution->id;
    if ((D == "ggx" || D == "ggx_aniso") && methods.visibility->id == "smith_corr") // glTF's anisotropy is 0: the same
        return;
    throw usageError("light from the environment, multiple scattering and weights by albedo are made for ggx with "
                     "smith_corr, not for " +
                         std::string(D) + " with " + std::string(methods.visibility->id),
                     "leave them out: --environment none --multiple-scattering none --diffuse-weight fresnel_voh");
}

[[noreturn]] void refuseView(const View& view, const std::string& lack, const std::string& remedy)
{
    throw usageError("the view of " + std::string(view.id) + " needs " + lack, remedy);
}

// A view of what the scene or the preset does not have is no black picture but an error.
void checkView(const ShadingPlan& plan, const brdf::Preset& methods)
{
    const View* view = plan.settings.view;
    if (!view)
        return;
    const bool ofLight = view->subject == ViewSubject::light || view->subject == ViewSubject::model;
    if (ofLight && plan.settings.viewLight >= static_cast<int>(plan.lights.size()))
        refuseView(*view,
                   "light " + std::to_string(plan.settings.viewLight) + ", and there are " +
                       std::to_string(plan.lights.size()),
                   "add one with --light, or choose another with --view-light");
    if (view->subject == ViewSubject::model && methods.model->id == "phong")
        refuseView(*view, "a microfacet model, which phong is not", "look at specular, diffuse or brdf");
    if (view->subject == ViewSubject::environment && !plan.environmentLight)
        refuseView(*view, "light from an environment", "give --environment, and a preset that defines it");
    if (view->id == "irradiance" && !methods.environmentDiffuse)
        refuseView(*view, "a preset with diffuse light from an environment", "look at prefiltered: what is mirrored");
    if (view->id == "prefiltered" && brdf::drawsSamples(*methods.environmentSpecular))
        refuseView(*view, "prefiltered light, which " + std::string(methods.environmentSpecular->id) + " does without",
                   "use --environment-specular split_sum");
    if (view->subject == ViewSubject::table && !methods.dfg)
        refuseView(*view, "a preset with directional albedos", "use --preset standard");
}

} // namespace

void checkMethods(const ShadingPlan& plan)
{
    for (const Settings& choice : plan.choices) {
        if (plan.environmentLight && !choice.methods.environmentSpecular)
            throw usageError("the preset " + std::string(choice.methods.id) + " defines no light from an environment",
                             "leave it out: --environment none");
        checkLevels(plan, choice.methods);
        checkLamps(plan, choice);
    }
    checkLobe(plan);
    for (const Settings& choice : plan.choices)
        checkView(plan, choice.methods);
}

} // namespace torrance
