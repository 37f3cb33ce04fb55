#include "study/measured_methods.h"

#include "files/csv_read.h"
#include "study/stability_atlas.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

std::optional<double> worstOf(const MethodVerdict& verdict, gpu::Precision precision)
{
    const auto found = std::ranges::find(verdict.precisions, precision, &PrecisionVerdict::precision);
    if (found == verdict.precisions.end() || !found->refusal.empty())
        return std::nullopt;
    return found->nonFinite.cells > 0 ? HUGE_VAL : found->worst.error;
}

// Three digits are what a map of this size is worth.
std::string cellOf(const std::optional<double>& error)
{
    return error ? fmt::format("{:.3g}", *error) : "";
}

std::optional<double> errorFrom(const CsvTable& table, std::size_t row, std::size_t column, const std::string& file)
{
    const std::string& cell = table.rows[row][column];
    if (cell.empty())
        return std::nullopt;
    return cell == "inf" ? HUGE_VAL : csvNumber(table, row, column, file);
}

} // namespace

MeasuredMethod measuredMethod(const MethodVerdict& verdict)
{
    MeasuredMethod measured = {.method = methodName(*verdict.method),
                               .fp32 = worstOf(verdict, gpu::Precision::fp32),
                               .fp16 = worstOf(verdict, gpu::Precision::fp16),
                               .models = {},
                               .energy = verdict.energy};
    for (const ModelVerdict& model : verdict.models)
        measured.models += fmt::format("{}{} {:.3g} (rms {:.2g})", measured.models.empty() ? "" : "; ",
                                       model.approximated->id, model.worst.error, model.rms);
    return measured;
}

std::string measuredCsv(std::span<const MeasuredMethod> methods)
{
    std::string text = "method,fp32,fp16,models,energy\n";
    for (const MeasuredMethod& m : methods)
        text +=
            fmt::format("{},{},{},{},{:.4g}\n", m.method, cellOf(m.fp32), cellOf(m.fp16), csvCell(m.models), m.energy);
    return text;
}

std::vector<MeasuredMethod> readMeasured(std::string_view csv, const std::string& file)
{
    const CsvTable table = parseCsv(csv, file);
    const std::size_t method = table.column("method", file), fp32 = table.column("fp32", file),
                      fp16 = table.column("fp16", file), models = table.column("models", file),
                      energy = table.column("energy", file);
    std::vector<MeasuredMethod> all;
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        all.push_back({.method = table.rows[row][method],
                       .fp32 = errorFrom(table, row, fp32, file),
                       .fp16 = errorFrom(table, row, fp16, file),
                       .models = table.rows[row][models],
                       .energy = csvNumber(table, row, energy, file)});
    return all;
}

} // namespace torrance
