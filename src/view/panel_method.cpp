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

constexpr int kMostSamplesLog2 = 12;
constexpr double kLeastPercent = 0.1, kMostPercent = 10.0; // of the slider for a tolerance

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
    std::vector<std::string> names = {"as the plan has it"};
    for (const RenderPath path :
         {RenderPath::forward, RenderPath::prepass, RenderPath::attributes, RenderPath::deferred})
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

void drawErrors(const PanelContext& context)
{
    ViewerState& state = context.state;
    state.moved |= ImGui::Checkbox("Show errors", &state.showsErrors);
    context.mark("method.errors");
    tipOfItem(
        "Each pixel against the model that was asked for, integrated exactly. Found beside everything else, from few "
        "pixels to all.");
    if (!state.showsErrors || state.errors.pixels == 0)
        return;
    note(fmt::format("mean {:.3g} % of the light, from {} pixels ({:.0f} % of the picture)", 100.0 * state.errors.mean,
                     state.errors.pixels, 100.0 * state.errors.done));
    note(fmt::format("black 0.0001 % and less, then a colour a decade, pale yellow 100 %; below {:.2g} % it is noise",
                     100.0 * state.errors.noise));
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

void drawTolerance(const PanelContext& context)
{
    ViewerState& state = context.state;
    double percent = 100.0 * state.tolerance;
    if (sliderDouble("tolerance", percent, kLeastPercent, kMostPercent, "%.2g %% of the light",
                     ImGuiSliderFlags_Logarithmic))
        state.tolerance = percent / 100.0;
    context.mark("method.tolerance");
    tipOfItem("The mean shading error that the picture may have, as --tolerance has it.");
    if (state.findsMethods) {
        if (ImGui::Button("Stop"))
            state.requests.push_back(StopFinding{});
        context.mark("method.stop");
        ImGui::SameLine();
        ImGui::TextUnformatted(state.pictureTried == 0
                                   ? "finding out what is exact"
                                   : fmt::format("picture {} is compared", state.pictureTried).c_str());
        return;
    }
    if (ImGui::Button("Find the cheapest methods within it"))
        state.requests.push_back(FindMethods{{.mean = state.tolerance, .percentile99 = {}}});
    context.mark("method.find");
    tipOfItem("Draws, compares some pixels with exact light, and takes nearer methods until the picture is within.");
    if (!state.found)
        return;
    const ToleranceResult& found = *state.found;
    if (state.scenesDrawn > state.foundAt)
        note("What was found for an earlier picture:");
    ImGui::Text("%.2g %%: %s", 100.0 * found.plan.tolerance.mean,
                found.holds ? "the picture is within it" : "out of reach");
    if (!found.obstacle.empty())
        note(found.obstacle);
    for (const std::string& line : toleranceLines(found))
        note(line);
}

std::string colorText(const dvec3& c)
{
    return c.x == c.y && c.y == c.z ? fmt::format("{:.6g}", c.x) : fmt::format("{:.5g} {:.5g} {:.5g}", c.x, c.y, c.z);
}

void drawTerms(const PixelProbe& probe)
{
    if (!ImGui::BeginTable("terms", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit))
        return;
    for (const char* title : {"term", "device", "in double", "off by"})
        ImGui::TableSetupColumn(title);
    ImGui::TableHeadersRow();
    for (const ProbedTerm& term : probe.terms) {
        const std::string name =
            term.slot == Slot::model ? "BRDF" : fmt::format("{} {}", brdf::slotName(term.slot), term.id);
        const double size = std::abs(term.exact.x) + std::abs(term.exact.y) + std::abs(term.exact.z);
        const dvec3 difference = glm::abs(dvec3(term.device) - term.exact);
        const double off = difference.x + difference.y + difference.z;
        for (const std::string& text : {name, colorText(dvec3(term.device)), colorText(term.exact),
                                        off == 0.0 ? std::string("0") : fmt::format("{:.1e}", off / size)})
        {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(text.c_str());
        }
    }
    ImGui::EndTable();
}

void drawProbe(const PanelContext& context)
{
    ViewerState& state = context.state;
    ImGui::Checkbox("Look into a pixel by clicking", &state.probes);
    context.mark("method.probe");
    if (!state.probe)
        return;
    const PixelProbe& probe = *state.probe;
    ImGui::Text("pixel %d, %d: %s", probe.pixel.x, probe.pixel.y, probe.material.c_str());
    note(fmt::format("roughness {:.3f}, metallic {:.3f}, n.v {:.3f}, base {}", probe.surface.perceptualRoughness,
                     probe.surface.metallic, probe.NoV, colorText(probe.surface.baseColor)));
    ImGui::Text("drawn %s", colorText(probe.drawn).c_str());
    ImGui::Text("exact %s", colorText(probe.exact).c_str());
    ImGui::Text("error %.3g %% (%.3g to %.3g)", 100.0 * probe.error.value, 100.0 * std::max(probe.error.low, 0.0),
                100.0 * probe.error.high);
    if (!probe.cause.slot.empty())
        note(
            fmt::format("{} {} makes {:.0f} % of it", probe.cause.slot, probe.cause.method, 100.0 * probe.cause.share));
    note("lit from " + probe.light + ":");
    drawTerms(probe);
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
    drawTolerance(context);
    ImGui::Checkbox("Show the plan", &context.state.showPlan);
    context.mark("method.plan");
    drawErrors(context);
    drawProbe(context);
}

} // namespace torrance
