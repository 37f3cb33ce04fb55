#include "app/tolerance_option.h"

#include "app/method_table_option.h"
#include "app/option_value.h"
#include "brdf/slot_option.h"
#include "core/error.h"
#include "study/certificate_file.h"
#include "study/error_numbers.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace torrance {
namespace {

double shareOf(const std::string& option, const std::string& text)
{
    const double share = parseShare(option, text);
    if (!(share > 0.0 && share <= 1.0))
        throw usageError(option + " " + text + ": must be above 0 and at most 1", "write 0.01, 1% or standard");
    return share;
}

bool isReplaced(const std::string& argument, const TolerancePlan& plan)
{
    for (const char* name : {"--tolerance", "--tolerance-p99", "--methods", "--material-methods"})
        if (argument == name || argument.starts_with(std::string(name) + "="))
            return true;
    return std::ranges::any_of(plan.ladders, [&](const MethodLadder& ladder) {
        return argument.starts_with(brdf::slotOption(ladder.slot) + "=");
    });
}

Json rungsJson(const std::vector<Rung>& rungs)
{
    Json::Object object;
    for (const Rung& rung : rungs) {
        object.emplace_back(std::string(brdf::slotName(rung.method->slot)), std::string(rung.method->id));
        if (rung.samples > 0)
            object.emplace_back(std::string(brdf::slotName(rung.method->slot)) + "_samples", rung.samples);
    }
    return object;
}

} // namespace

double parseTolerance(const std::string& text)
{
    for (const NamedTolerance& named : kNamedTolerances)
        if (text == named.name || (text.empty() && named.name == "standard"))
            return named.mean;
    return shareOf("--tolerance", text);
}

void declareToleranceOption(CLI::App& app, ToleranceOption& option)
{
    option.given =
        app.add_option("--tolerance", option.mean,
                       "Choose methods so that the mean shading error is at most this share of the light, and certify "
                       "it: 0.01, 1%, draft (5 %), standard (1 %, where nothing is named) or exact (0.1 %)")
            ->group("Methods")
            ->type_name("E")
            ->expected(0, 1);
    app.add_option("--tolerance-p99", option.percentile99, "The same of the 99th percentile of the pixels' errors")
        ->group("Methods")
        ->type_name("E");
    declareMethodTableOption(app, option.methods);
}

std::optional<Tolerance> chosenTolerance(const ToleranceOption& option)
{
    if (!option.given || option.given->count() == 0) {
        if (!option.percentile99.empty() || option.methods != "shipped")
            throw usageError(option.percentile99.empty() ? "--methods is what a tolerance chooses from"
                                                         : "--tolerance-p99 goes with a tolerance of the mean",
                             "add --tolerance");
        return std::nullopt;
    }
    Tolerance tolerance = {.mean = parseTolerance(option.mean), .percentile99 = {}};
    if (!option.percentile99.empty())
        tolerance.percentile99 = shareOf("--tolerance-p99", option.percentile99);
    return tolerance;
}

std::vector<std::string> argumentsFound(std::vector<std::string> arguments, const ToleranceResult& found)
{
    const TolerancePlan& plan = found.plan;
    std::erase_if(arguments, [&](const std::string& argument) { return isReplaced(argument, plan); });
    for (const MethodLadder& ladder : plan.ladders) {
        const Rung& rung = ladder.taken();
        arguments.push_back(brdf::slotOption(ladder.slot) + "=" + std::string(rung.method->id));
        if (rung.samples > 0)
            arguments.push_back(fmt::format(
                "--{}={}", ladder.slot == brdf::Slot::areaLight ? kLightSamplesName : kEnvironmentSamplesName,
                rung.samples));
    }
    for (const auto& [material, own] : found.settings.ofMaterials)
        arguments.push_back("--material-methods=" + materialMethodsText(material, own));
    return arguments;
}

Json toleranceJson(const ToleranceResult& result, const std::string& tableHash)
{
    const Tolerance& tolerance = result.plan.tolerance;
    Json::Array trials;
    for (const ToleranceTrial& trial : result.trials)
        trials.emplace_back(Json::Object{{"methods", rungsJson(trial.rungs)},
                                         {"cheaper_materials", Json::Array(trial.cheaper.begin(), trial.cheaper.end())},
                                         {"mean", boundedJson(trial.mean)},
                                         {"percentile_99", boundedJson(trial.percentile99)}});
    Json::Object object = {{"mean", tolerance.mean},
                           {"percentile_99", tolerance.percentile99 ? Json(*tolerance.percentile99) : Json()},
                           {"holds", result.holds},
                           {"nearest", isNearest(result.plan)},
                           {"methods_table", tableHash},
                           {"trials", trials}};
    if (!result.obstacle.empty())
        object.emplace_back("obstacle", result.obstacle);
    return object;
}

std::string toleranceText(const ToleranceResult& result)
{
    std::string text = "tolerance\n";
    for (const std::string& line : toleranceLines(result))
        text += "  " + line + "\n";
    return text;
}

} // namespace torrance
