#include "study/chart_page.h"

#include "files/json_write.h"
#include "study/markup.h"

#include <algorithm>
#include <fmt/format.h>

namespace torrance {
namespace {

// Inside of a script element this ends it, wherever it stands; in strings of JSON and JavaScript the other is the same.
std::string inScript(std::string text)
{
    constexpr std::string_view kEnd = "</script", kHarmless = "<\\/script";
    for (std::size_t at = 0; (at = text.find(kEnd, at)) != std::string::npos; at += kHarmless.size())
        text.replace(at, kEnd.size(), kHarmless);
    return text;
}

Json markAsJson(const ChartMark& mark, std::size_t index)
{
    Json::Array details;
    for (const auto& [term, value] : mark.details)
        details.emplace_back(Json::Array{term, value});
    Json::Object object = {{"index", index},
                           {"name", mark.name},
                           {"label", mark.label},
                           {"group", mark.group},
                           {"order", index},
                           {"x", mark.x},
                           {"y", std::max(mark.y, kLeastShown)},
                           {"front", mark.front},
                           {"chosen", mark.chosen},
                           {"details", std::move(details)},
                           {"picture", mark.picture},
                           {"error", mark.error},
                           {"cite", mark.citation}};
    if (mark.interval) {
        object.emplace_back("low", mark.interval->first);
        object.emplace_back("high", mark.interval->second);
    }
    return object;
}

Json asJson(const ChartPage& page)
{
    Json::Array panels;
    for (const ChartPanel& panel : page.panels) {
        Json::Array points;
        for (std::size_t i = 0; i < panel.marks.size(); ++i)
            points.push_back(markAsJson(panel.marks[i], i));
        Json::Array rules;
        for (const ChartRule& rule : panel.rules)
            rules.emplace_back(Json::Object{{"label", rule.label}, {"y", rule.y}});
        panels.push_back(Json::Object{{"id", panel.id},
                                      {"kind", panel.kind == ChartKind::bars ? "bars" : "front"},
                                      {"x", panel.x},
                                      {"y", panel.y},
                                      {"points", std::move(points)},
                                      {"rules", std::move(rules)}});
    }
    return Json::Object{{"panels", std::move(panels)}};
}

std::string tableText(const ChartPanel& panel)
{
    if (panel.columns.empty())
        return "";
    std::string text = "<details open><summary>Numbers</summary><div class=\"wide\"><table>\n<thead><tr>";
    for (const std::string& column : panel.columns)
        text += fmt::format("<th scope=\"col\">{}</th>", markupEscaped(column));
    text += "</tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < panel.rows.size(); ++i) {
        text += i < panel.frontRows.size() && panel.frontRows[i] ? "<tr class=\"front\">" : "<tr>";
        for (const std::string& cell : panel.rows[i])
            text += fmt::format("<td>{}</td>", markupEscaped(cell));
        text += "</tr>\n";
    }
    return text + "</tbody>\n</table></div></details>\n";
}

std::string panelText(const ChartPanel& panel)
{
    std::string text = fmt::format("<section>\n<h2>{}</h2>\n", markupEscaped(panel.title));
    if (!panel.text.empty())
        text += fmt::format("<p class=\"soft\">{}</p>\n", markupEscaped(panel.text));
    if (!panel.marks.empty())
        text += fmt::format("<div class=\"chart\" id=\"chart-{}\"></div>\n", panel.id);
    return text + tableText(panel) + "</section>\n";
}

} // namespace

std::string chartHtml(const ChartPage& page, const ChartScripts& scripts)
{
    const std::string title = markupEscaped(page.title);
    std::string text = fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                                   "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                                   "<link rel=\"icon\" href=\"data:,\">\n<title>{0}</title>\n<style>\n{1}</style>\n"
                                   "</head>\n<body>\n<h1>{0}</h1>\n",
                                   title, scripts.style);
    for (const std::string& paragraph : page.introduction)
        text += fmt::format("<p>{}</p>\n", markupEscaped(paragraph));
    for (const ChartPanel& panel : page.panels)
        text += panelText(panel);
    text += "<div id=\"tip\" role=\"tooltip\"></div>\n";
    text += "<script type=\"application/json\" id=\"data\">\n" + inScript(jsonText(asJson(page))) + "</script>\n";
    text += "<script>\n" + inScript(scripts.vega) + "</script>\n<script>\n" + inScript(scripts.page) + "</script>\n";
    return text + "</body>\n</html>\n";
}

} // namespace torrance
