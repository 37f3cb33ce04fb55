#include "brdf/environment.h"
#include "plan/path_plan.h"
#include "plan/view.h"
#include "view/panels.h"
#include "view/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace torrance {
namespace {

constexpr int kMostSamplesLog2 = 12; // of the sliders

using brdf::Method;
using brdf::Slot;

// A preset's own lamp goes with it, where it is the only light.
void exchangeLamp(const PanelContext& context, const brdf::Preset& from, const brdf::Preset& to)
{
    Edits edits = context.state.edits();
    if (const std::optional<Light> old = context.host.lampOf(from))
        std::erase(edits.lights, *old);
    if (const std::optional<Light> lamp = context.host.lampOf(to); lamp && edits.lights.empty())
        edits.lights.push_back(*lamp);
    context.state.history->commit(std::move(edits));
}

void choosePreset(const PanelContext& context)
{
    ViewerState& state = context.state;
    std::vector<std::string> names;
    int chosen = -1;
    for (const brdf::Preset& preset : brdf::allPresets()) {
        if (preset.id == state.settings.methods.id)
            chosen = static_cast<int>(names.size());
        names.emplace_back(preset.id);
    }
    const auto tip = [](int i) { return std::string(brdf::allPresets()[static_cast<std::size_t>(i)].description); };
    if (choose(context, "preset", names, chosen, tip)) {
        const brdf::Preset& preset = brdf::allPresets()[static_cast<std::size_t>(chosen)];
        exchangeLamp(context, *brdf::findPreset(state.settings.methods.id), preset);
        state.settings.methods = preset;
        state.changed = true;
    }
    context.mark("method.preset");
}

bool isChosenInPresets(Slot slot)
{
    return slot != Slot::tone && slot != Slot::transfer && slot != Slot::sheen;
}

void chooseMethod(const PanelContext& context, Slot slot)
{
    ViewerState& state = context.state;
    const Method* current = state.settings.methods[slot];
    if (!current)
        return; // the model has a term of its own
    std::vector<const Method*> methods;
    std::vector<std::string> names;
    int chosen = -1;
    for (const Method& method : brdf::allMethods()) {
        if (method.slot != slot || (!method.ownModel.empty() && method.ownModel != state.settings.methods.model->id))
            continue;
        if (&method == current)
            chosen = static_cast<int>(methods.size());
        methods.push_back(&method);
        names.emplace_back(method.id);
    }
    std::string label(brdf::slotName(slot));
    std::ranges::replace(label, '_', ' ');
    const auto tip = [&](int i) {
        const Method& method = *methods[static_cast<std::size_t>(i)];
        return std::string(method.citation) +
               (method.approximates.empty() ? "" : "\nin place of " + std::string(method.approximates));
    };
    if (choose(context, label.c_str(), names, chosen, tip)) {
        state.settings.methods[slot] = methods[static_cast<std::size_t>(chosen)];
        state.changed = true;
    }
    context.mark(fmt::format("method.{}", brdf::slotName(slot)));
}

void choosePath(const PanelContext& context)
{
    ViewerState& state = context.state;
    int chosen = state.settings.path ? static_cast<int>(*state.settings.path) + 1 : 0;
    std::vector<std::string> names = {"by the plan"};
    for (const RenderPath path : kRenderPaths)
        names.emplace_back(nameOf(path));
    if (choose(context, "path", names, chosen)) {
        state.settings.path = chosen == 0 ? std::nullopt : std::optional(static_cast<RenderPath>(chosen - 1));
        state.changed = true;
    }
    context.mark("method.path");
}

void chooseView(const PanelContext& context)
{
    ViewerState& state = context.state;
    std::vector<std::string> names = {"the picture"};
    std::vector<const View*> views = {nullptr};
    int chosen = 0;
    for (const View& view : allViews()) {
        if (view.subject == ViewSubject::picture)
            continue;
        if (&view == state.settings.view)
            chosen = static_cast<int>(names.size());
        names.emplace_back(view.id);
        views.push_back(&view);
    }
    const auto tip = [&](int i) {
        const View* view = views[static_cast<std::size_t>(i)];
        return view ? std::string(view->text) : std::string();
    };
    if (choose(context, "show", names, chosen, tip)) {
        state.settings.view = views[static_cast<std::size_t>(chosen)];
        state.changed = true;
    }
    context.mark("method.view");
}

// Directions of a method that sums over some.
void chooseSamples(const PanelContext& context, const char* label, int& samples)
{
    int exponent = static_cast<int>(std::lround(std::log2(samples)));
    if (ImGui::SliderInt(label, &exponent, 0, kMostSamplesLog2, fmt::format("{}", samples).c_str(),
                         ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput))
    {
        samples = 1 << exponent;
        context.state.changed = true;
    }
    context.mark(std::string("method.") + label);
}

} // namespace

void drawMethodPanel(const PanelContext& context)
{
    chooseView(context);
    choosePreset(context);
    for (const Slot slot : brdf::allSlots())
        if (isChosenInPresets(slot))
            chooseMethod(context, slot);
    const brdf::Preset& methods = context.state.settings.methods;
    if (methods.environmentSpecular && brdf::drawsSamples(*methods.environmentSpecular))
        chooseSamples(context, "environment samples", context.state.settings.environmentSamples);
    if (methods.areaLight && methods.areaLight->id == "sampled")
        chooseSamples(context, "light samples", context.state.settings.lightSamples);
    choosePath(context);
    drawTolerancePanel(context);
    ImGui::Checkbox("Show the plan", &context.state.showPlan);
    context.mark("method.plan");
    drawErrorPanel(context);
}

} // namespace torrance
