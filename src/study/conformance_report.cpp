#include "study/conformance_report.h"

#include "core/error.h"
#include "image/display.h"
#include "measure/heat_map.h"
#include "study/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

// Of a failure all that is known; of a pass the worst of it.
std::string detailsOf(const ConformanceGroup& group, const ConformanceResult& result)
{
    if (result.passed())
        return result.worst;
    return fmt::format("{}\n{}{}{}", group.expectation, result.fault, result.fault.empty() ? "" : "\n", result.worst);
}

std::string placeOf(const ConformanceResult& result)
{
    if (result.passed())
        return result.place;
    return result.fault.empty() ? result.worst : result.fault;
}

Image displayed(const Image& picture)
{
    return toDisplay(picture, {});
}

// Decades of the share of what is allowed: black is a thousandth or less, the middle 3 %, pale yellow all or more.
Image differenceMap(const Image& excess)
{
    constexpr float kDecades = 3.0f;
    Image scaled = excess;
    for (float& e : scaled.texels)
        e = e > 0.0f ? 1.0f + std::log10(e) / kDecades : 0.0f;
    return heatMap(scaled);
}

constexpr int kColumns = 8;
constexpr int kSheetWidth = 400; // about, in pixels: a sheet of small pictures is enlarged
constexpr int kLargeWidth = 200; // likewise a single one

std::vector<const ConformanceResult*> pictured(const ConformanceGroup& group)
{
    std::vector<const ConformanceResult*> results;
    for (const ConformanceResult& result : group.results)
        if (!result.drawn.texels.empty())
            results.push_back(&result);
    return results;
}

HtmlPictures sheets(const std::vector<const ConformanceResult*>& results)
{
    std::vector<Image> drawn, exact, differences;
    for (const ConformanceResult* result : results) {
        drawn.push_back(displayed(result->drawn));
        exact.push_back(displayed(result->exact));
        differences.push_back(differenceMap(result->difference));
    }
    HtmlPictures pictures = {
        {{contactSheet(drawn, kColumns), "Drawn by the device, in the order of the table"},
         {contactSheet(exact, kColumns), "Computed in double precision"},
         {contactSheet(differences, kColumns), "Difference as a share of what is allowed, in decades: black is a "
                                               "thousandth or less, pale yellow all of it or more"}}};
    for (HtmlPicture& sheet : pictures.pictures)
        sheet.zoom = std::max(1, kSheetWidth / sheet.image.width);
    return pictures;
}

void addLarge(HtmlReport& report, const ConformanceResult& result)
{
    report.parts.push_back(HtmlHeading{result.name, 3});
    report.parts.push_back(HtmlParagraph{result.worst});
    const int zoom = std::max(1, kLargeWidth / result.drawn.width);
    report.parts.push_back(HtmlPictures{{{displayed(result.drawn), "Drawn", zoom},
                                         {displayed(result.exact), "Exact", zoom},
                                         {differenceMap(result.difference), "Difference", zoom}}});
}

HtmlTable tableOf(const ConformanceGroup& group)
{
    HtmlTable table{{"case", "result", "error / allowed", "worst at"}, {}};
    for (const ConformanceResult& result : group.results) {
        const HtmlCell verdict = result.passed() ? HtmlCell("pass", HtmlMark::good) : HtmlCell("FAIL", HtmlMark::bad);
        table.rows.push_back({result.name, verdict, fmt::format("{:.3g}", result.excess), placeOf(result)});
    }
    return table;
}

void addGroup(HtmlReport& report, const ConformanceGroup& group)
{
    report.parts.push_back(HtmlHeading{group.name, 2});
    report.parts.push_back(HtmlParagraph{group.expectation});
    const std::vector<const ConformanceResult*> results = pictured(group);
    if (!results.empty()) {
        report.parts.push_back(sheets(results));
        const ConformanceResult* worst = std::ranges::max(results, {}, &ConformanceResult::excess);
        for (const ConformanceResult* result : results)
            if (result == worst || !result->passed())
                addLarge(report, *result);
    }
    report.parts.push_back(tableOf(group));
}

HtmlTable summary(std::span<const ConformanceGroup> groups)
{
    HtmlTable table{{"group", "cases", "failed", "worst error / allowed"}, {}};
    for (const ConformanceGroup& group : groups) {
        const auto failed = std::ranges::count_if(group.results, [](const auto& r) { return !r.passed(); });
        const double worst = std::ranges::max(group.results, {}, &ConformanceResult::excess).excess;
        table.rows.push_back({group.name, std::to_string(group.results.size()),
                              HtmlCell(std::to_string(failed), failed > 0 ? HtmlMark::bad : HtmlMark::good),
                              fmt::format("{:.3g}", worst)});
    }
    return table;
}

} // namespace

std::string shortFault(const ConformanceResult& result)
{
    if (!result.fault.empty())
        return oneLine(result.fault.substr(0, result.fault.find('\n')));
    return fmt::format("{:.3g} of what is allowed at {}", result.excess, result.place);
}

std::vector<JunitSuite> conformanceSuites(std::span<const ConformanceGroup> groups)
{
    std::vector<JunitSuite> suites;
    for (const ConformanceGroup& group : groups) {
        JunitSuite& suite = suites.emplace_back(JunitSuite{group.name, {}});
        for (const ConformanceResult& result : group.results)
            suite.cases.push_back({result.name, result.passed() ? CaseResult::passed : CaseResult::failed,
                                   result.passed() ? "" : shortFault(result), detailsOf(group, result)});
    }
    return suites;
}

HtmlReport conformanceReport(std::span<const ConformanceGroup> groups, const gpu::DeviceDescription& device)
{
    HtmlReport report{"Conformance of " + device.name, {}};
    report.parts.push_back(HtmlParagraph{fmt::format(
        "Driver {} {}, Vulkan {}. What the device drew is held against what the processor computed in "
        "double precision from the same inputs. Errors are given as shares of what is allowed: up to 1 passes.",
        device.driver, device.driverVersion, device.apiVersion)});
    report.parts.push_back(summary(groups));
    for (const ConformanceGroup& group : groups)
        addGroup(report, group);
    return report;
}

} // namespace torrance
