// How wrong the picture is, and what one pixel is made of.
#include "view/panels.h"
#include "view/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace torrance {
namespace {

using brdf::Slot;

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

void drawErrorPanel(const PanelContext& context)
{
    drawErrors(context);
    drawProbe(context);
}

} // namespace torrance
