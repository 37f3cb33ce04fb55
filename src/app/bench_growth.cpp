#include "app/bench_session.h"
#include "app/bench_text.h"
#include "app/device_option.h"
#include "app/option_value.h"
#include "app/progress_line.h"
#include "core/error.h"
#include "core/nearest_name.h"
#include "study/growth.h"

#include <algorithm>
#include <sstream>

namespace torrance {

std::vector<const GrowthSeries*> chosenGrowthSeries(const std::string& names)
{
    std::vector<const GrowthSeries*> chosen;
    std::vector<std::string> known = {"all"};
    for (const GrowthSeries& series : growthSeries())
        known.emplace_back(series.id);
    std::istringstream stream(names);
    for (std::string name; std::getline(stream, name, ',');) {
        if (std::ranges::find(known, name) == known.end()) {
            const std::string nearest = nearestName(name, known);
            throw usageError("--growth: unknown series " + name,
                             nearest.empty() ? "known are " + listed(known) : "did you mean " + nearest + "?");
        }
        for (const GrowthSeries& series : growthSeries())
            if (name == "all" || name == series.id)
                chosen.push_back(&series);
    }
    return chosen;
}

ExitCode benchGrowth(BenchSession& session, const std::vector<const GrowthSeries*>& chosen)
{
    const BenchOptions& options = session.options;
    GrowthRecord record = {.bench = session.emptyRecord(), .series = {}};
    const auto open = [&] { return openDevice(options.device, session.global); };
    for (const GrowthSeries* series : chosen) {
        ProgressLine progress(std::string(series->id));
        record.series.push_back(measureGrowth(open, session.shaders, cacheFolder(session.global), *series,
                                              frameSettings(options.frame), session.environment,
                                              boundsOf(options, kGrowthSeconds),
                                              [&](int done, int all) { progress.show(done, all); }));
        progress.clear();
        session.say(textOf(record.series.back(), session.clock));
    }
    writeJson(session.global.json, asJson(record));
    session.writeCsv(growthCsv(record.series));
    const bool tooFast =
        std::ranges::any_of(record.series, [&](const auto& m) { return growsTooFast(m, session.clock); });
    return tooFast ? ExitCode::checkFailed : ExitCode::success;
}

} // namespace torrance
