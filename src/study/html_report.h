// A report for people: one HTML file that needs nothing beside it. Plain data, and its text.
#pragma once

#include "image/image.h"

#include <string>
#include <variant>
#include <vector>

namespace torrance {

struct HtmlHeading
{
    std::string text;
    int level = 2; // 2 to 4; 1 is the report's title
};

struct HtmlParagraph
{
    std::string text;
};

/// Shown as a colour and, for those who see no colours, as bold type where it is bad.
enum class HtmlMark
{
    none,
    good,
    bad,
};

struct HtmlCell
{
    std::string text;
    HtmlMark mark = HtmlMark::none;

    HtmlCell(std::string t, HtmlMark m = HtmlMark::none) : text(std::move(t)), mark(m) {}
    HtmlCell(const char* t, HtmlMark m = HtmlMark::none) : text(t), mark(m) {}
};

struct HtmlTable
{
    std::vector<std::string> columns;
    std::vector<std::vector<HtmlCell>> rows; // as many cells as there are columns
};

struct HtmlPicture
{
    Image image; // display-encoded in [0, 1], 1, 3 or 4 channels: of toDisplay or heatMap
    std::string caption;
    int zoom = 1; // a texel is drawn as a square of so many pixels, where there is room
};

/// Side by side, as many as the page is wide.
struct HtmlPictures
{
    std::vector<HtmlPicture> pictures;
};

struct HtmlLink
{
    std::string text;
    std::string target; // a file beside the report, or "#" and the text of a heading
};

/// In one line.
struct HtmlLinks
{
    std::vector<HtmlLink> links;
};

using HtmlPart = std::variant<HtmlHeading, HtmlParagraph, HtmlTable, HtmlPictures, HtmlLinks>;

struct HtmlReport
{
    std::string title;
    std::vector<HtmlPart> parts;
};

/// HTML 5, pictures inline as PNG, light or dark as the reader's system is, no scripts and nothing from the network.
/// All text is escaped. The same report gives the same bytes.
std::string htmlText(const HtmlReport& report);

} // namespace torrance
