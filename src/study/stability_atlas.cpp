#include "study/stability_atlas.h"

#include "study/error_map.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

using brdf::ShadingPoint;
using brdf::Slot;

std::string fileStem(const brdf::Method& method)
{
    return fmt::format("{}_{}", brdf::slotName(method.slot), method.id);
}

template <typename Cell>
std::vector<double> errorsOf(const std::vector<Cell>& cells)
{
    std::vector<double> errors(cells.size());
    std::ranges::transform(cells, errors.begin(), &Cell::error);
    return errors;
}

std::string place(const ShadingPoint& at)
{
    return fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}", at.NoV, at.NoL, at.VoH, std::sqrt(at.sin2H));
}

std::string csvRows(const PrecisionSweep& sweep, const SweepAxes& axes)
{
    std::string text;
    for (std::size_t i = 0; i < sweep.cells.size(); ++i) {
        const CellError& cell = sweep.cells[i];
        text += fmt::format("{},{:.9g},{:.9g},{:.6g},{:.6g},{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                            gpu::precisionName(sweep.precision), axes.cosines[i % axes.cosines.size()],
                            axes.rows[i / axes.cosines.size()], cell.error, cell.excess, cell.nonFinite, cell.negative,
                            place(cell.at), cell.device.x, cell.device.y, cell.device.z, cell.exact.x, cell.exact.y,
                            cell.exact.z);
    }
    return text;
}

std::string csvRows(const ModelVerdict& model, const SweepAxes& axes)
{
    std::string text;
    for (std::size_t i = 0; i < model.cells.size(); ++i)
        text += fmt::format("against {},{:.9g},{:.9g},{:.6g},,,,{},,,,,,\n", model.approximated->id,
                            axes.cosines[i % axes.cosines.size()], axes.rows[i / axes.cosines.size()],
                            model.cells[i].error, place(model.cells[i].at));
    return text;
}

std::string csvText(const MethodVerdict& verdict)
{
    const AxisNames names = axisNames(verdict.method->slot);
    std::string text = fmt::format("what,{},{},error,excess,non_finite,negative,at_NoV,at_NoL,at_VoH,at_sinNoH,"
                                   "device_r,device_g,device_b,exact_r,exact_g,exact_b\n",
                                   names.cosine, names.row);
    for (const PrecisionSweep& sweep : verdict.sweeps)
        text += csvRows(sweep, verdict.axes);
    for (const ModelVerdict& model : verdict.models)
        text += csvRows(model, verdict.axes);
    return text;
}

std::vector<AtlasMap> mapsOf(const MethodVerdict& verdict)
{
    const std::string stem = fileStem(*verdict.method);
    std::vector<AtlasMap> maps;
    for (const PrecisionSweep& sweep : verdict.sweeps)
        if (sweep.refusal.empty())
            maps.push_back({fmt::format("{}_{}.png", stem, gpu::precisionName(sweep.precision)),
                            fmt::format("{}: device against double", gpu::precisionName(sweep.precision)),
                            errorMap(errorsOf(sweep.cells), verdict.axes)});
    for (const ModelVerdict& model : verdict.models)
        maps.push_back({fmt::format("{}_against_{}.png", stem, model.approximated->id),
                        fmt::format("model error against {}", model.approximated->id),
                        errorMap(errorsOf(model.cells), verdict.axes)});
    return maps;
}

bool isSound(const MethodVerdict& verdict)
{
    for (const PrecisionVerdict& precision : verdict.precisions)
        if (precision.precision == gpu::Precision::fp32 &&
            (precision.nonFinite.cells > 0 || precision.negative.cells > 0 || precision.unexplained.cells > 0))
            return false;
    return verdict.gainsEnergy.cells == 0;
}

HtmlPart summary(std::span<const AtlasEntry> entries)
{
    HtmlTable table = {.columns = {"method", "verdict"}, .rows = {}};
    for (const AtlasEntry& entry : entries) {
        std::string text;
        for (const std::string& line : entry.lines)
            text += (text.empty() ? "" : " ") + line;
        table.rows.push_back({HtmlCell(entry.name, entry.sound ? HtmlMark::good : HtmlMark::bad), HtmlCell(text)});
    }
    return table;
}

void addEntry(HtmlReport& report, const AtlasEntry& entry)
{
    report.parts.emplace_back(HtmlHeading{entry.name});
    for (const std::string& line : entry.lines)
        report.parts.emplace_back(HtmlParagraph{line});
    HtmlPictures pictures;
    for (const AtlasMap& map : entry.maps)
        pictures.pictures.push_back({map.picture, map.title, 1});
    report.parts.emplace_back(std::move(pictures));
    report.parts.emplace_back(HtmlParagraph{entry.legend});
    HtmlLinks links = {{{"Every cell as a table", entry.csvFile}}};
    for (const AtlasMap& map : entry.maps)
        links.links.push_back({map.file, map.file});
    report.parts.emplace_back(std::move(links));
}

} // namespace

std::string methodName(const brdf::Method& method)
{
    return fmt::format("{}/{}", brdf::slotName(method.slot), method.id);
}

AtlasEntry atlasEntry(const MethodVerdict& verdict)
{
    return {.name = methodName(*verdict.method),
            .csvFile = fileStem(*verdict.method) + ".csv",
            .csv = csvText(verdict),
            .maps = mapsOf(verdict),
            .legend = errorMapLegend(verdict.method->slot, verdict.axes),
            .lines = verdictLines(verdict),
            .sound = isSound(verdict)};
}

HtmlReport atlasReport(std::span<const AtlasEntry> entries, const std::string& deviceName)
{
    HtmlReport report = {.title = "Stability atlas", .parts = {}};
    report.parts.emplace_back(HtmlParagraph{
        "Every shading method on " + deviceName +
        ", its own text in 16, 32 and 64 bits, against its formula in double. An error is relative to the exact value. "
        "The "
        "cosines that a method is given are rounded and, besides, moved one unit in the last place up and down, "
        "because "
        "no device knows a dot product better. A model error is that of the formula itself, in double, against what it "
        "stands in for, relative to that plus 1 % of the cell's greatest value."});
    HtmlLinks links;
    for (const AtlasEntry& entry : entries)
        links.links.push_back({entry.name, "#" + entry.name});
    report.parts.emplace_back(std::move(links));
    report.parts.emplace_back(summary(entries));
    for (const AtlasEntry& entry : entries)
        addEntry(report, entry);
    return report;
}

} // namespace torrance
