// Fronts as a drawing by itself, for documents and for builds without a script library.
#include "study/chart_page.h"
#include "study/markup.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace torrance {
namespace {

constexpr double kWidth = 760, kHeight = 380; // of a panel
constexpr double kLeft = 80, kRight = 140, kTop = 44, kBottom = 52;
constexpr const char* kColors[] = {"#1f5fbf", "#b45309", "#0f766e", "#7c3aed"};

// An axis of decades where values span some, even otherwise.
struct Axis
{
    double low, high;
    bool decades;

    double place(double value) const
    {
        const double v = std::clamp(value, low, high);
        return decades ? std::log(v / low) / std::log(high / low) : (v - low) / (high - low);
    }
};

Axis axisOf(const std::vector<double>& values)
{
    constexpr double kDecadesFrom = 6.0, kMargin = 0.12;
    const auto [low, high] = std::ranges::minmax(values);
    if (high / low > kDecadesFrom)
        return {low / 1.5, high * 1.5, true};
    const double span = high > low ? high - low : high;
    return {low - kMargin * span, high + kMargin * span, false};
}

std::vector<double> ticksOf(const Axis& axis)
{
    std::vector<double> ticks;
    if (axis.decades) {
        for (double t = std::pow(10.0, std::floor(std::log10(axis.low))); t <= axis.high; t *= 10.0)
            for (const double factor : {1.0, 2.0, 5.0})
                if (t * factor >= axis.low && t * factor <= axis.high)
                    if (factor == 1.0 || axis.high / axis.low < 100.0)
                        ticks.push_back(t * factor);
        return ticks;
    }
    const double rough = (axis.high - axis.low) / 6.0, power = std::pow(10.0, std::floor(std::log10(rough)));
    const double step = rough / power > 5   ? 10 * power
                        : rough / power > 2 ? 5 * power
                        : rough / power > 1 ? 2 * power
                                            : power;
    for (double t = std::ceil(axis.low / step) * step; t <= axis.high; t += step)
        ticks.push_back(t);
    return ticks;
}

struct Frame
{
    Axis x, y;
    double top;

    double right(double value) const { return kLeft + x.place(value) * (kWidth - kLeft - kRight); }
    double down(double value) const { return top + kHeight - kBottom - y.place(value) * (kHeight - kTop - kBottom); }
};

double shownError(const ChartMark& mark)
{
    return std::max(mark.y, kLeastShown);
}

std::string axesText(const ChartPanel& panel, const Frame& frame)
{
    const double bottom = frame.top + kHeight - kBottom, ceiling = frame.top + kTop, end = kWidth - kRight;
    std::string text;
    for (const double t : ticksOf(frame.x))
        text += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" y=\"{3:.1f}\" "
                            "text-anchor=\"middle\" fill=\"#555\">{4:.4g}</text>\n",
                            frame.right(t), ceiling, bottom, bottom + 18, t);
    for (const double t : ticksOf(frame.y))
        text += fmt::format("<path d=\"M{0} {1:.1f}H{2}\" stroke=\"#ddd\"/><text x=\"{3}\" y=\"{4:.1f}\" "
                            "text-anchor=\"end\" fill=\"#555\">{5:.3g}</text>\n",
                            kLeft, frame.down(t), end, kLeft - 8, frame.down(t) + 4, t);
    return text + fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n"
                              "<text transform=\"translate(18 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                              0.5 * (kLeft + end), bottom + 40, markupEscaped(panel.x), 0.5 * (ceiling + bottom),
                              markupEscaped(panel.y));
}

std::string rulesText(const ChartPanel& panel, const Frame& frame)
{
    std::string text;
    for (const ChartRule& rule : panel.rules)
        text +=
            fmt::format("<path d=\"M{0} {1:.1f}H{2}\" stroke=\"#b3121d\" stroke-dasharray=\"5 4\"/><text x=\"{2}\" "
                        "y=\"{3:.1f}\" text-anchor=\"end\" fill=\"#b3121d\">{4}</text>\n",
                        kLeft, frame.down(rule.y), kWidth - kRight, frame.down(rule.y) - 4, markupEscaped(rule.label));
    return text;
}

std::string frontText(const ChartPanel& panel, const Frame& frame, const std::string& group, const char* color)
{
    std::vector<const ChartMark*> front;
    for (const ChartMark& mark : panel.marks)
        if (mark.front && mark.group == group)
            front.push_back(&mark);
    std::ranges::sort(front, {}, &ChartMark::x);
    std::string path;
    for (const ChartMark* mark : front)
        path += path.empty() ? fmt::format("M{:.1f} {:.1f}", frame.right(mark->x), frame.down(shownError(*mark)))
                             : fmt::format("H{:.1f}V{:.1f}", frame.right(mark->x), frame.down(shownError(*mark)));
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", path, color);
}

std::string marksText(const ChartPanel& panel, const Frame& frame, const std::vector<std::string>& groups)
{
    std::string text;
    for (const ChartMark& mark : panel.marks) {
        const auto group = static_cast<std::size_t>(std::ranges::find(groups, mark.group) - groups.begin());
        const double x = frame.right(mark.x), y = frame.down(shownError(mark));
        if (mark.chosen)
            text += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"9\" fill=\"none\" stroke=\"#b3121d\" "
                                "stroke-width=\"2\"/>\n",
                                x, y);
        text +=
            fmt::format("<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"5\" fill=\"{2}\"><title>{3}</title></circle>"
                        "<text x=\"{4:.1f}\" y=\"{5:.1f}\" fill=\"{6}\">{7}</text>\n",
                        x, y, mark.front ? kColors[group % std::size(kColors)] : "#a3a3aa", markupEscaped(mark.name),
                        x + 8, y - 5, mark.front ? "#1c1c1e" : "#77777f", markupEscaped(mark.label));
    }
    return text;
}

std::string panelText(const ChartPanel& panel, double top)
{
    std::vector<double> xs, ys;
    std::vector<std::string> groups;
    for (const ChartMark& mark : panel.marks) {
        xs.push_back(mark.x);
        ys.push_back(shownError(mark));
        if (std::ranges::find(groups, mark.group) == groups.end())
            groups.push_back(mark.group);
    }
    for (const ChartRule& rule : panel.rules)
        ys.push_back(rule.y);
    const Frame frame = {axisOf(xs), axisOf(ys), top};
    std::string text = fmt::format("<g><text x=\"{}\" y=\"{}\" font-size=\"18\" font-weight=\"bold\">{}</text>\n",
                                   kLeft, top + 26, markupEscaped(panel.title));
    text += axesText(panel, frame) + rulesText(panel, frame);
    for (std::size_t i = 0; i < groups.size(); ++i)
        text += frontText(panel, frame, groups[i], kColors[i % std::size(kColors)]);
    return text + marksText(panel, frame, groups) + "</g>\n";
}

} // namespace

std::string chartSvg(const ChartPage& page)
{
    std::string panels;
    double top = 0.0;
    for (const ChartPanel& panel : page.panels)
        if (panel.kind == ChartKind::front && !panel.marks.empty()) {
            panels += panelText(panel, top);
            top += kHeight;
        }
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
                       "font-family=\"sans-serif\" font-size=\"12\">\n<title>{2}</title>\n"
                       "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{3}</svg>\n",
                       kWidth, top, markupEscaped(page.title), panels);
}

} // namespace torrance
