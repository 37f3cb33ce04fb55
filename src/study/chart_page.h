// A page of charts: one HTML file that opens without a network, its panels drawn by Vega.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace torrance {

/// One mark of a panel: a point of a front, or a part of a bar.
struct ChartMark
{
    std::string name;                                  // in full
    std::string label;                                 // beside the mark
    std::string group;                                 // points: what fronts are drawn for; bars: the part
    double x = 0.0;                                    // points: cost
    std::optional<std::pair<double, double>> interval; // of x
    double y = 0.0;                                    // points: error, above 0; bars: the part's share
    bool front = false;                                // nothing cheaper is as good
    bool chosen = false;                               // what is drawn where nothing else is asked for
    std::vector<std::pair<std::string, std::string>> details;
    std::string picture; // PNG in base64, empty: none
    std::string error;
    std::string citation;
};

/// A value of the y axis that points are held against.
struct ChartRule
{
    std::string label;
    double y = 0.0; // above 0
};

enum class ChartKind
{
    front,
    bars,
};

struct ChartPanel
{
    std::string id; // of letters, digits, _ and -: one of the page's own
    ChartKind kind = ChartKind::front;
    std::string title;
    std::string text;
    std::string x, y; // axes
    std::vector<ChartMark> marks;
    std::vector<ChartRule> rules = {};
    std::vector<std::string> columns; // of a table below, none: no table
    std::vector<std::vector<std::string>> rows;
    std::vector<bool> frontRows; // of the table
};

struct ChartPage
{
    std::string title;
    std::vector<std::string> introduction; // paragraphs
    std::vector<ChartPanel> panels;
};

/// The files of the data folder that a page is put together from.
struct ChartScripts
{
    std::string vega, page, style;
};

/// All text is escaped. Marks below kLeastShown are drawn there: an axis of decades has no zero.
std::string chartHtml(const ChartPage& page, const ChartScripts& scripts);

/// Panels of fronts below each other as a drawing by itself: axes, fronts, names.
std::string chartSvg(const ChartPage& page);

inline constexpr double kLeastShown = 1e-8;

} // namespace torrance
