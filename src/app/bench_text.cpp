#include "app/bench_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

constexpr double kMilliseconds = 1000.0;
constexpr double kMebibyte = 1024.0 * 1024.0;

// "12.3 [12.1, 12.5]"; the interval only where there is one.
std::string withInterval(const Estimate& estimate, double unit)
{
    const std::string median = fmt::format("{:.3g}", estimate.median * unit);
    if (!std::isfinite(estimate.low) || !std::isfinite(estimate.high))
        return median;
    return fmt::format("{} [{:.3g}, {:.3g}]", median, estimate.low * unit, estimate.high * unit);
}

std::size_t nameWidth(const BenchRecord& record)
{
    std::size_t width = 0;
    for (const BenchResult& result : record.results)
        width = std::max(width, result.name.size());
    return width;
}

std::string tableOf(const BenchRecord& record)
{
    const std::size_t width = nameWidth(record);
    std::string text =
        fmt::format("{:{}}  {:26}  {:26}  {:>6}\n", "", width, "CPU ms a frame", "wall ms a frame", "frames");
    for (const BenchResult& r : record.results) {
        text += fmt::format("{:{}}  {:26}  {:26}  {:>6}", r.name, width, withInterval(r.processor, kMilliseconds),
                            withInterval(r.wall, kMilliseconds), r.processor.count);
        if (r.ratio)
            text += fmt::format("  {} times the first", withInterval(*r.ratio, 1.0));
        text += "\n";
    }
    return text;
}

std::string detailsOf(const BenchResult& result)
{
    std::string text =
        fmt::format("{}: {}x{}, {} triangles, {} draws, {} pipelines, {:.0f} MiB held\n  passes, CPU ms:", result.name,
                    result.width, result.height, result.triangles, result.draws, result.pipelines,
                    static_cast<double>(result.heldBytes) / kMebibyte);
    for (const BenchPass& pass : result.passes)
        text += fmt::format(" {} {:.3g}{}", pass.name, pass.processor.median * kMilliseconds,
                            &pass == &result.passes.back() ? "" : ",");
    text += "\n  start-up, wall ms:";
    for (const PhaseTime& phase : result.startUp)
        text += fmt::format(" {} {:.3g}{}", phase.name, phase.use.wall * kMilliseconds,
                            &phase == &result.startUp.back() ? "" : ",");
    return text + "\n";
}

std::string_view textOf(SpeedVerdict verdict)
{
    switch (verdict) {
    case SpeedVerdict::faster:
        return "faster";
    case SpeedVerdict::slower:
        return "SLOWER";
    case SpeedVerdict::perhapsSlower:
        return "perhaps slower: measure longer";
    case SpeedVerdict::asFast:
        break;
    }
    return "as fast";
}

} // namespace

std::string textOf(const BenchRecord& record, const BenchBounds& bounds)
{
    std::string text = fmt::format("{} cores of {}; {}, {}\n", record.machine.cores, record.machine.processor,
                                   record.machine.device, record.machine.driver);
    text += tableOf(record);
    for (const BenchResult& result : record.results)
        text += detailsOf(result);
    text += fmt::format("memory: peak {:.0f} MiB (PSS, sampled), {:.0f} MiB resident with all that is shared\n",
                        static_cast<double>(record.peakBytes) / kMebibyte,
                        static_cast<double>(record.peakResidentBytes) / kMebibyte);
    for (const BenchResult& r : record.results)
        if (const double width = r.of(record.clock).relativeWidth(); !r.settled)
            text += fmt::format(
                "not settled: {}: {}; give more --seconds or --frames, or quieten the machine\n", r.name,
                std::isfinite(width) ? fmt::format("the interval of its median is {:.1f} % wide, not {:.0f} %",
                                                   100.0 * width, 100.0 * bounds.width)
                                     : "too few frames for an interval");
    return text;
}

std::string textOf(const std::vector<SpeedComparison>& comparisons, double limit)
{
    std::string text;
    for (const SpeedComparison& c : comparisons)
        text += fmt::format("{}: {} times the earlier time, limit {:.3g}: {}\n", c.name, withInterval(c.ratio, 1.0),
                            limit, textOf(c.verdict));
    return text;
}

std::string withPrefix(double value, const std::string& unit)
{
    struct Prefix
    {
        double factor;
        const char* text;
    };
    constexpr Prefix kPrefixes[] = {{1e9, "G"},  {1e6, "M"},  {1e3, "k"}, {1.0, ""},
                                    {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}};
    for (const Prefix& prefix : kPrefixes)
        if (std::abs(value) >= 0.9995 * prefix.factor)
            return fmt::format("{:.3g} {}{}", value / prefix.factor, prefix.text, unit);
    return fmt::format("{:.2g} n{}", value * 1e9, unit);
}

std::string textOf(const GrowthFit& fit, const GrowthMeasurement& measurement, const std::string& unit)
{
    const std::string constant = withPrefix(fit.constant.median, unit);
    if (fit.kind == GrowthKind::none)
        return constant + ", does not grow";
    std::string text =
        fmt::format("{} + {} a {}", constant, withPrefix(fit.slope.median, unit), measurement.series->unit);
    if (std::isfinite(fit.slope.low))
        text += fmt::format(" [{}, {}]", withPrefix(fit.slope.low, unit), withPrefix(fit.slope.high, unit));
    return text + fmt::format(", exponent {}: {}", withInterval(fit.exponent, 1.0), nameOf(fit.kind));
}

std::string textOf(const GrowthMeasurement& measurement, BenchClock clock)
{
    const GrowthSeries& series = *measurement.series;
    std::string text = fmt::format("{}: {:.0f} to {:.0f}, {} rounds\n", series.id, series.sizes.front(),
                                   series.sizes.back(), measurement.rounds.size());
    for (const GrowthCost cost : kGrowthCosts)
        text += fmt::format("  {:11}  {}\n", nameOf(cost),
                            textOf(measurement.fit(cost, clock), measurement, cost == GrowthCost::memory ? "B" : "s"));
    return text;
}

std::string textOf(const SoakVerdict& verdict, std::size_t renders)
{
    const auto mebibytes = [](std::uint64_t bytes) { return static_cast<double>(bytes) / kMebibyte; };
    return fmt::format(
        "{} renders: {:.1f} MiB of its own after {}, {:.1f} at the end; allocated {:.1f} and {:.1f} MiB: "
        "{:+.2f} %, at most {:.0f} %: {}\n",
        renders, mebibytes(verdict.afterWarmUp.own), kSoakWarmUp, mebibytes(verdict.atEnd.own),
        mebibytes(verdict.afterWarmUp.allocated), mebibytes(verdict.atEnd.allocated), 100.0 * verdict.growth,
        100.0 * kMostSoakGrowth, verdict.passed() ? "passed" : "GROWS");
}

} // namespace torrance
