#include "study/html_report.h"

#include "files/image_encoders.h"
#include "study/base64.h"
#include "study/markup.h"

#include <cassert>
#include <fmt/format.h>

namespace torrance {
namespace {

// Pictures shrink to the page's width; wide tables scroll by themselves, so that the page does not. Behind what is
// transparent lies a grey, on which black and white are both seen.
constexpr const char* kStyle = R"(:root { color-scheme: light dark; --text: #1c1c1e; --page: #ffffff; --line: #c9c9ce;
  --soft: #5c5c62; --good: #1a6e35; --bad: #b3121d; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e6e6ea; --page: #17171a; --line: #44444b; --soft: #a2a2aa; --good: #6fd08c; --bad: #ff8a8a; } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--text); background: var(--page); max-width: 78rem;
  margin: 0 auto; padding: 1rem; overflow-wrap: break-word; }
h1, h2, h3, h4 { line-height: 1.2; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; overflow-wrap: normal; }
th, td { text-align: left; vertical-align: top; padding: .25rem .75rem .25rem 0; border-bottom: 1px solid var(--line); }
.wide td:last-child { min-width: 14rem; }
.good { color: var(--good); }
.bad { color: var(--bad); font-weight: bold; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; margin: 1rem 0; }
figure { margin: 0; max-width: 100%; }
figcaption { color: var(--soft); font-size: .875rem; contain: inline-size; }
img { background: #808080; display: block; max-width: 100%; height: auto; image-rendering: pixelated; }
)";

std::string_view classOf(HtmlMark mark)
{
    switch (mark) {
    case HtmlMark::good:
        return " class=\"good\"";
    case HtmlMark::bad:
        return " class=\"bad\"";
    case HtmlMark::none:
        break;
    }
    return "";
}

std::string partText(const HtmlHeading& heading)
{
    assert(heading.level >= 2 && heading.level <= 4);
    return fmt::format("<h{0} id=\"{1}\">{1}</h{0}>\n", heading.level, markupEscaped(heading.text));
}

std::string partText(const HtmlParagraph& paragraph)
{
    return fmt::format("<p>{}</p>\n", markupEscaped(paragraph.text));
}

std::string partText(const HtmlTable& table)
{
    std::string text = "<div class=\"wide\"><table>\n<thead><tr>";
    for (const std::string& column : table.columns)
        text += fmt::format("<th scope=\"col\">{}</th>", markupEscaped(column));
    text += "</tr></thead>\n<tbody>\n";
    for (const std::vector<HtmlCell>& row : table.rows) {
        assert(row.size() == table.columns.size());
        text += "<tr>";
        for (const HtmlCell& cell : row)
            text += fmt::format("<td{}>{}</td>", classOf(cell.mark), markupEscaped(cell.text));
        text += "</tr>\n";
    }
    return text + "</tbody>\n</table></div>\n";
}

std::string partText(const HtmlPictures& pictures)
{
    std::string text = "<div class=\"pictures\">\n";
    for (const HtmlPicture& picture : pictures.pictures)
        text += fmt::format("<figure><img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"data:image/png;base64,{}\">"
                            "<figcaption>{}</figcaption></figure>\n",
                            picture.image.width * picture.zoom, picture.image.height * picture.zoom,
                            markupEscaped(picture.caption), base64(encodePng(picture.image, 8)),
                            markupEscaped(picture.caption));
    return text + "</div>\n";
}

std::string partText(const HtmlLinks& links)
{
    std::string text;
    for (const HtmlLink& link : links.links)
        text += fmt::format("{}<a href=\"{}\">{}</a>", text.empty() ? "<p>" : " · ", markupEscaped(link.target),
                            markupEscaped(link.text));
    return text + "</p>\n";
}

} // namespace

std::string htmlText(const HtmlReport& report)
{
    const std::string title = markupEscaped(report.title);
    std::string text =
        fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{0}</title>\n"
                    "<style>\n{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n",
                    title, kStyle);
    for (const HtmlPart& part : report.parts)
        text += std::visit([](const auto& p) { return partText(p); }, part);
    return text + "</body>\n</html>\n";
}

} // namespace torrance
