#include "study/method_table_file.h"

#include "core/error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <limits>

namespace torrance {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

double threeDigits(double value)
{
    return std::strtod(fmt::format("{:.3g}", value).c_str(), nullptr);
}

Json::Array numbers(const std::vector<double>& values)
{
    return {values.begin(), values.end()};
}

Json asJson(const Measured& m)
{
    return Json::Object{{"median", m.median}, {"low", m.low}, {"high", m.high}};
}

Json cellsAsJson(const std::vector<double>& cells)
{
    Json::Array values;
    for (const double cell : cells)
        values.emplace_back(threeDigits(cell));
    return values;
}

Json asJson(const MethodError& e)
{
    return Json::Object{{"mean", e.mean},
                        {"rms", e.rms},
                        {"worst", e.worst},
                        {"flip", e.flip},
                        {"noise", e.noise},
                        {"cells_mean", cellsAsJson(e.cells)},
                        {"cells_worst", cellsAsJson(e.cellWorst)}};
}

double notNegative(const JsonView& json)
{
    const double value = json.numberOr(kInfinite);
    if (!(value >= 0.0))
        json.refuse("is negative");
    return value;
}

Measured measuredFrom(const JsonView& json)
{
    const Measured m = {.median = json.member("median").number(),
                        .low = json.member("low").numberOr(-kInfinite),
                        .high = json.member("high").numberOr(kInfinite)};
    if (!(m.median > 0.0 && m.low <= m.median && m.median <= m.high))
        json.refuse("is no median of times in its interval");
    return m;
}

std::vector<double> cellsFrom(const JsonView& json, const MethodGrid& grid)
{
    std::vector<double> cells;
    for (const JsonView& cell : json.elements()) {
        cells.push_back(cell.numberOr(kUnknown));
        if (cells.back() < 0.0)
            cell.refuse("is negative");
    }
    if (!cells.empty() && cells.size() != grid.cells())
        json.refuse(fmt::format("has {} cells, and the grid {}", cells.size(), grid.cells()));
    return cells;
}

MethodError errorFrom(const JsonView& json, const MethodGrid& grid)
{
    return {.mean = notNegative(json.member("mean")),
            .rms = notNegative(json.member("rms")),
            .worst = notNegative(json.member("worst")),
            .flip = notNegative(json.member("flip")),
            .noise = notNegative(json.member("noise")),
            .cells = cellsFrom(json.member("cells_mean"), grid),
            .cellWorst = cellsFrom(json.member("cells_worst"), grid)};
}

std::vector<double> ascendingFrom(const JsonView& json)
{
    std::vector<double> values;
    for (const JsonView& element : json.elements()) {
        const double value = element.number();
        if (!(value >= 0.0 && value <= 1.0) || (!values.empty() && value <= values.back()))
            element.refuse("is not in [0, 1] and above the one before");
        values.push_back(value);
    }
    if (values.size() < 2)
        json.refuse("has fewer than two values");
    return values;
}

MethodGrid gridFrom(const JsonView& json)
{
    return {.roughnesses = ascendingFrom(json.member("roughness")),
            .reflectances = ascendingFrom(json.member("f0")),
            .cosines = ascendingFrom(json.member("nov_edges"))};
}

// Tables are whole: a choice is among all methods that there are.
void requireRegistry(const MethodTable& table, const std::string& file)
{
    const auto known = brdf::allMethods();
    for (const brdf::Method& method : known)
        if (std::ranges::find(table.rows, &method, &MethodRow::method) == table.rows.end())
            throw inputError(file, "/methods", fmt::format("lacks {}/{}", brdf::slotName(method.slot), method.id),
                             "measure again: torrance calibrate");
    if (table.rows.size() != known.size())
        throw inputError(file, "/methods", "names a method twice", "measure again: torrance calibrate");
}

} // namespace

Json asJson(const MethodRow& row)
{
    Json::Object object = {{"slot", std::string(brdf::slotName(row.method->slot))},
                           {"id", std::string(row.method->id)},
                           {"truth", row.truth},
                           {"note", row.note}};
    if (row.cost)
        object.emplace_back("cost", Json::Object{{"ns_per_pixel", asJson(row.cost->nanoseconds)},
                                                 {"ratio", asJson(row.cost->ratio)},
                                                 {"frames", row.cost->frames}});
    if (row.error)
        object.emplace_back("error", asJson(*row.error));
    return object;
}

Json asJson(const MethodTable& table)
{
    Json::Array rows;
    for (const MethodRow& row : table.rows)
        rows.push_back(asJson(row));
    return Json::Object{{"schema", std::string(kMethodTableSchema)},
                        {"program", table.program},
                        {"date", table.date},
                        {"processor", table.processor},
                        {"cores", table.cores},
                        {"system", table.system},
                        {"device", table.device},
                        {"driver", table.driver},
                        {"environment", table.environment},
                        {"grid", Json::Object{{"roughness", numbers(table.grid.roughnesses)},
                                              {"f0", numbers(table.grid.reflectances)},
                                              {"nov_edges", numbers(table.grid.cosines)},
                                              {"order", "cells by f0, then roughness, then n.v"}}},
                        {"methods", std::move(rows)}};
}

MethodRow methodRowFrom(const JsonView& json, const MethodGrid& grid)
{
    const std::string slotText = json.member("slot").text(), id = json.member("id").text();
    const std::optional<brdf::Slot> slot = brdf::findSlot(slotText);
    const brdf::Method* method = slot ? brdf::findMethod(*slot, id) : nullptr;
    if (!method)
        json.refuse(slotText + "/" + id + " is no method of this program");
    MethodRow row = {.method = method,
                     .truth = json.member("truth").text(),
                     .note = json.member("note").text(),
                     .cost = {},
                     .error = {}};
    if (json.has("cost")) {
        const JsonView cost = json.member("cost");
        row.cost = {.nanoseconds = measuredFrom(cost.member("ns_per_pixel")),
                    .ratio = measuredFrom(cost.member("ratio")),
                    .frames = static_cast<std::size_t>(std::clamp(cost.member("frames").number(), 0.0, 1e9))};
    }
    if (json.has("error"))
        row.error = errorFrom(json.member("error"), grid);
    return row;
}

MethodTable parseMethodTable(std::string_view text, const std::string& file)
{
    const Json json = parseJson(text, file);
    const JsonView view(json, file);
    if (const std::string schema = view.member("schema").text(); schema != kMethodTableSchema)
        throw inputError(file, "/schema",
                         "is " + schema + ", and this program reads " + std::string(kMethodTableSchema),
                         "measure again: torrance calibrate");
    MethodTable table = {.program = view.member("program").text(),
                         .date = view.member("date").text(),
                         .processor = view.member("processor").text(),
                         .cores = static_cast<int>(std::clamp(view.member("cores").number(), 0.0, 1e6)),
                         .system = view.member("system").text(),
                         .device = view.member("device").text(),
                         .driver = view.member("driver").text(),
                         .environment = view.member("environment").text(),
                         .grid = gridFrom(view.member("grid")),
                         .rows = {}};
    for (const JsonView& row : view.member("methods").elements())
        table.rows.push_back(methodRowFrom(row, table.grid));
    requireRegistry(table, file);
    return table;
}

void requireDevice(const MethodTable& table, const std::string& file, const std::string& device,
                   const std::string& driver)
{
    if (table.device != device || table.driver != driver)
        throw inputError(file, "",
                         "was measured on " + table.device + " with " + table.driver + ", and this is " + device +
                             " with " + driver,
                         "measure this one: torrance calibrate -o FILE");
}

} // namespace torrance
