#include "app/bench_session.h"
#include "app/bench_text.h"
#include "app/device_option.h"
#include "app/progress_line.h"
#include "core/read_file.h"
#include "study/bench.h"

#include <algorithm>

namespace torrance {
namespace {

constexpr double kDefaultLimit = 1.1;

BenchRecord readRecord(const std::string& file)
{
    const std::vector<std::byte> bytes = readFile(file);
    return parseBenchRecord({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file);
}

std::vector<TimedItem> startItems(BenchSession& session, BenchRecord& record)
{
    MemorySampler memory;
    std::vector<TimedItem> items;
    for (const BenchSource& source : benchSources(session.options, session.variants, session.environment)) {
        items.push_back({source, std::make_unique<BenchItem>(session.device, session.shaders,
                                                             cacheFolder(session.global), source)});
        record.results.push_back(describe(items.back()));
    }
    record.peakBytes = memory.peak();
    return items;
}

BenchRun timeItems(BenchSession& session, std::vector<TimedItem>& items, const BenchRecord& record)
{
    const BenchBounds bounds = boundsOf(session.options, kFrameSeconds);
    ProgressLine progress("seconds");
    const int seconds = std::max(static_cast<int>(bounds.seconds * static_cast<double>(items.size())), 1);
    return runBench(items, record.results, bounds, session.clock,
                    [&](double elapsed) { progress.show(std::clamp(static_cast<int>(elapsed), 1, seconds), seconds); });
}

ExitCode judge(const BenchSession& session, const BenchRecord& then, const BenchRecord& now)
{
    const double limit = session.options.limit.value_or(kDefaultLimit);
    const std::vector<SpeedComparison> comparisons = compareSpeed(then, now, limit);
    session.say(textOf(comparisons, limit));
    const bool slower =
        std::ranges::find(comparisons, SpeedVerdict::slower, &SpeedComparison::verdict) != comparisons.end();
    return slower ? ExitCode::checkFailed : ExitCode::success;
}

} // namespace

ExitCode benchScenes(BenchSession& session)
{
    const BenchOptions& options = session.options;
    // What cannot be compared is refused before minutes are spent.
    std::optional<BenchRecord> then;
    if (!options.against.empty())
        then = readRecord(options.against);
    BenchRecord record = session.emptyRecord();
    std::vector<TimedItem> items = startItems(session, record);
    if (then)
        requireComparable(*then, options.against, record);
    BenchRun run = timeItems(session, items, record);
    session.writeCsv(framesAsCsv(run));
    record.results = std::move(run.results);
    record.peakResidentBytes = peakResidentBytes();
    session.say(textOf(record, boundsOf(options, kFrameSeconds)));
    writeJson(session.global.json, asJson(record));
    return then ? judge(session, *then, record) : ExitCode::success;
}

} // namespace torrance
