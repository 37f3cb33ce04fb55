#include "study/chart_methods_page.h"

#include "study/slot_trial.h"

#include <algorithm>
#include <fmt/format.h>

namespace torrance {
namespace {

const char* lightText(TrialScene trial)
{
    switch (trial) {
    case TrialScene::lamps:
        return "Seven directional lights; costs under one.";
    case TrialScene::environment:
        return "Light from the environment.";
    case TrialScene::uniform:
        return "The same light from everywhere.";
    case TrialScene::areaLights:
        return "Two lights with a radius; costs under one.";
    case TrialScene::bumps:
        return "Bumps finer than a pixel under seven directional lights; costs under one.";
    case TrialScene::picture:
        return "The same picture of light, shown; the processor's time.";
    case TrialScene::none:
        break;
    }
    return "Nothing is drawn with this slot.";
}

std::string percent(double share)
{
    return share >= 1e-4 ? fmt::format("{:.3g} %", 100.0 * share) : fmt::format("{:.2g}", share);
}

std::string withInterval(const Measured& m)
{
    return fmt::format("{:.3g} [{:.3g}, {:.3g}]", m.median, m.low, m.high);
}

ChartMark markOf(const MethodRow& row, const EncodedPictures& pictures, bool front)
{
    const MethodError& e = *row.error;
    ChartMark mark = {.name = fmt::format("{}/{}", brdf::slotName(row.method->slot), row.method->id),
                      .label = std::string(row.method->id),
                      .group = row.truth,
                      .x = row.cost->nanoseconds.median,
                      .interval = std::pair(row.cost->nanoseconds.low, row.cost->nanoseconds.high),
                      .y = e.mean,
                      .front = front,
                      .chosen = row.method == referenceMethod(row.method->slot),
                      .details = {{"against", row.truth},
                                  {"mean error", percent(e.mean)},
                                  {"rms, worst", percent(e.rms) + ", " + percent(e.worst)},
                                  {"FLIP", fmt::format("{:.3g}", e.flip)},
                                  {"ns a pixel", withInterval(row.cost->nanoseconds)},
                                  {"times standard's", withInterval(row.cost->ratio)}},
                      .picture = pictures.drawn,
                      .error = pictures.error,
                      .citation = std::string(row.method->citation)};
    if (e.noise > 0.0)
        mark.details.insert(mark.details.begin() + 2, {"truth's noise", percent(e.noise)});
    return mark;
}

std::vector<std::string> tableRow(const MethodRow& row)
{
    std::vector<std::string> cells = {std::string(row.method->id)};
    if (row.cost)
        cells.insert(cells.end(), {withInterval(row.cost->nanoseconds), withInterval(row.cost->ratio)});
    else
        cells.insert(cells.end(), {"", ""});
    if (row.error)
        cells.insert(cells.end(), {percent(row.error->mean), percent(row.error->rms), percent(row.error->worst),
                                   fmt::format("{:.3g}", row.error->flip)});
    else
        cells.insert(cells.end(), {"", "", "", ""});
    cells.push_back(row.note.empty() ? "against " + row.truth : row.note);
    return cells;
}

ChartPanel panelOf(const MethodChart& chart, const std::vector<bool>& front, brdf::Slot slot)
{
    ChartPanel panel = {.id = std::string(brdf::slotName(slot)),
                        .kind = ChartKind::front,
                        .title = std::string(brdf::slotName(slot)),
                        .text = lightText(trialScene(slot)),
                        .x = "ns a pixel",
                        .y = "mean relative error",
                        .marks = {},
                        .columns = {"method", "ns a pixel", "times standard's", "mean", "rms", "worst", "FLIP", ""},
                        .rows = {},
                        .frontRows = {}};
    for (std::size_t i = 0; i < chart.table.rows.size(); ++i) {
        const MethodRow& row = chart.table.rows[i];
        if (row.method->slot != slot)
            continue;
        panel.rows.push_back(tableRow(row));
        panel.frontRows.push_back(front[i]);
        if (row.cost && row.error)
            panel.marks.push_back(
                markOf(row, i < chart.pictures.size() ? chart.pictures[i] : EncodedPictures(), front[i]));
    }
    return panel;
}

} // namespace

ChartPage methodsPage(const MethodChart& chart)
{
    const MethodTable& t = chart.table;
    ChartPage page = {
        .title = "What shading methods cost, and how far off they are",
        .introduction =
            {fmt::format("{}, {}; {}, {} cores; environment {}; {}; {}.", t.device, t.driver, t.processor, t.cores,
                         t.environment, t.date, t.program),
             "Each method is drawn in the place of the one that the preset standard has in its slot (of distribution "
             "and visibility, the preset gltf), on spheres of eight roughnesses: a dielectric and three metals. "
             "Cost: frames of the methods of a slot in turn, median with its 95 % interval. Error: the sum of "
             "|d - c| over that of |c|, d drawn and c the truth in double; rms and worst of single pixels.",
             "Coloured: on the front, nothing cheaper that stands for the same truth is as good; a colour and a line "
             "for each truth. Grey: dominated. Diamond: standard's. Error maps run from 1e-6 and less (black) to 1 "
             "and more (pale yellow), a decade per sixth."},
        .panels = {}};
    const std::vector<bool> front = frontRows(t);
    for (const brdf::Slot slot : brdf::allSlots())
        if (hasSlot(chart, slot))
            page.panels.push_back(panelOf(chart, front, slot));
    return page;
}

} // namespace torrance
