#include "study/chart_methods.h"

#include "core/error.h"
#include "files/csv_read.h"
#include "files/image_encoders.h"
#include "measure/pareto.h"
#include "study/base64.h"

#include <algorithm>
#include <fmt/format.h>

namespace torrance {
namespace {

constexpr std::string_view kPartSchema = "torrance-chart-part/1";

std::string encoded(const Image& picture)
{
    return picture.texels.empty() ? "" : base64(encodePng(picture, 8));
}

std::string cells(const Measured& m)
{
    return fmt::format("{:.4g},{:.4g},{:.4g}", m.median, m.low, m.high);
}

} // namespace

bool hasSlot(const MethodChart& chart, brdf::Slot slot)
{
    return std::ranges::any_of(chart.table.rows, [&](const MethodRow& row) { return row.method->slot == slot; });
}

void addSlot(MethodChart& chart, const MeasuredSlot& slot)
{
    chart.table.rows.insert(chart.table.rows.end(), slot.rows.begin(), slot.rows.end());
    for (const MethodPictures& pictures : slot.pictures)
        chart.pictures.push_back({encoded(pictures.drawn), encoded(pictures.error)});
}

std::vector<bool> frontRows(const MethodTable& table)
{
    std::vector<bool> front(table.rows.size(), false);
    for (std::size_t first = 0; first < table.rows.size(); ++first) {
        // Once for each slot and truth, at its first row.
        std::vector<std::size_t> group;
        for (std::size_t i = 0; i < table.rows.size(); ++i) {
            const MethodRow &row = table.rows[i], &of = table.rows[first];
            if (row.method->slot == of.method->slot && row.truth == of.truth && row.cost && row.error)
                group.push_back(i);
        }
        if (group.empty() || group.front() != first)
            continue;
        std::vector<CostAndError> points;
        for (const std::size_t i : group)
            points.push_back({table.rows[i].cost->nanoseconds.median, table.rows[i].error->mean});
        for (const std::size_t i : paretoFront(points))
            front[group[i]] = true;
    }
    return front;
}

std::string partText(const MethodChart& chart, const std::string& inputs)
{
    Json::Array rows;
    for (std::size_t i = 0; i < chart.table.rows.size(); ++i)
        rows.push_back(Json::Object{{"row", asJson(chart.table.rows[i])},
                                    {"drawn", chart.pictures[i].drawn},
                                    {"error", chart.pictures[i].error}});
    return jsonText(Json::Object{{"schema", std::string(kPartSchema)}, {"inputs", inputs}, {"rows", std::move(rows)}});
}

MethodChart parsePart(std::string_view text, const std::string& file, const std::string& inputs, MethodChart chart)
{
    const Json json = parseJson(text, file);
    const JsonView view(json, file);
    if (view.member("schema").text() != kPartSchema || view.member("inputs").text() != inputs)
        throw inputError(file, "", "was left by another chart: other options, device or program",
                         "remove it, or repeat the command that was interrupted");
    for (const JsonView& row : view.member("rows").elements()) {
        chart.table.rows.push_back(methodRowFrom(row.member("row"), chart.table.grid));
        chart.pictures.push_back({row.member("drawn").text(), row.member("error").text()});
    }
    return chart;
}

std::string methodsCsv(const MethodTable& table)
{
    std::string text = "slot,method,truth,ns_per_pixel,ns_low,ns_high,ratio,ratio_low,ratio_high,mean,rms,worst,flip,"
                       "noise,front,note\n";
    const std::vector<bool> front = frontRows(table);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const MethodRow& row = table.rows[i];
        text += fmt::format("{},{},{},", brdf::slotName(row.method->slot), row.method->id, csvCell(row.truth));
        text += row.cost ? cells(row.cost->nanoseconds) + "," + cells(row.cost->ratio) : ",,,,,";
        text += row.error ? fmt::format(",{:.4g},{:.4g},{:.4g},{:.4g},{:.2g}", row.error->mean, row.error->rms,
                                        row.error->worst, row.error->flip, row.error->noise)
                          : ",,,,,";
        text += fmt::format(",{},{}\n", front[i] ? 1 : 0, csvCell(row.note));
    }
    return text;
}

} // namespace torrance
