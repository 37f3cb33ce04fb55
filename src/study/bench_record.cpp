#include "study/bench_record.h"

#include "core/error.h"
#include "files/json_parse.h"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <sched.h>

namespace torrance {
namespace {

constexpr double kMilliseconds = 1000.0;
constexpr double kMebibyte = 1024.0 * 1024.0;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The value of the first line of a file that begins with `key` and has one after `mark`; `otherwise` where none does.
std::string lineOf(const char* file, std::string_view key, char mark, const std::string& otherwise)
{
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        const std::size_t at = line.find(mark);
        if (!line.starts_with(key) || at == std::string::npos)
            continue;
        std::string value = line.substr(at + 1);
        std::erase(value, '"');
        value.erase(0, value.find_first_not_of(" \t"));
        return oneLine(value);
    }
    return otherwise;
}

int usableCores()
{
    cpu_set_t set;
    CPU_ZERO(&set);
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

const char* nameOf(BenchClock clock)
{
    return clock == BenchClock::wall ? "wall" : "processor";
}

Json phasesAsJson(const std::vector<PhaseTime>& phases)
{
    Json::Object object;
    for (const PhaseTime& phase : phases)
        object.emplace_back(phase.name, Json::Object{{"cpu_ms", phase.use.processor * kMilliseconds},
                                                     {"wall_ms", phase.use.wall * kMilliseconds}});
    return object;
}

Json passesAsJson(const std::vector<BenchPass>& passes)
{
    Json::Object object;
    for (const BenchPass& pass : passes)
        object.emplace_back(pass.name, Json::Object{{"cpu_ms", asJson(pass.processor, kMilliseconds)},
                                                    {"wall_ms", asJson(pass.wall, kMilliseconds)}});
    return object;
}

Json resultAsJson(const BenchResult& r)
{
    Json::Object object = {{"name", r.name},
                           {"width", r.width},
                           {"height", r.height},
                           {"samples", r.samples},
                           {"path", r.path},
                           {"methods", r.methods},
                           {"triangles", r.triangles},
                           {"draws", r.draws},
                           {"pipelines", r.pipelines},
                           {"cpu_ms", asJson(r.processor, kMilliseconds)},
                           {"wall_ms", asJson(r.wall, kMilliseconds)},
                           {"settled", r.settled}};
    if (r.ratio)
        object.emplace_back("ratio", asJson(*r.ratio, 1.0));
    object.emplace_back("passes", passesAsJson(r.passes));
    object.emplace_back("start_up", phasesAsJson(r.startUp));
    object.emplace_back("held_mib", static_cast<double>(r.heldBytes) / kMebibyte);
    return object;
}

Estimate estimateFrom(const JsonView& json, double unit)
{
    const Estimate estimate = {.median = json.member("median").number() / unit,
                               .low = json.member("low").numberOr(-kInfinite) / unit,
                               .high = json.member("high").numberOr(kInfinite) / unit,
                               .count = static_cast<std::size_t>(std::max(json.member("count").number(), 0.0))};
    if (!(estimate.median > 0.0 && estimate.low <= estimate.median && estimate.median <= estimate.high))
        json.refuse("is no median of times in its interval");
    return estimate;
}

int wholeFrom(const JsonView& json)
{
    return static_cast<int>(std::clamp(json.number(), 0.0, 1e9));
}

BenchResult resultFrom(const JsonView& json)
{
    BenchResult r;
    r.name = json.member("name").text();
    r.width = wholeFrom(json.member("width"));
    r.height = wholeFrom(json.member("height"));
    r.samples = wholeFrom(json.member("samples"));
    r.methods = json.member("methods").text();
    r.triangles = static_cast<std::size_t>(wholeFrom(json.member("triangles")));
    r.processor = estimateFrom(json.member("cpu_ms"), kMilliseconds);
    r.wall = estimateFrom(json.member("wall_ms"), kMilliseconds);
    return r;
}

// Of the two of a name, what must agree; empty where all does.
std::string difference(const BenchResult& then, const BenchResult& now)
{
    if (then.width != now.width || then.height != now.height)
        return fmt::format("{}x{}, and {}x{} now", then.width, then.height, now.width, now.height);
    if (then.samples != now.samples)
        return fmt::format("{} samples, and {} now", then.samples, now.samples);
    if (then.triangles != now.triangles)
        return fmt::format("{} triangles, and {} now", then.triangles, now.triangles);
    if (then.methods != now.methods)
        return "other methods of shading";
    return "";
}

std::string machineDifference(const BenchRecord& then, const BenchRecord& now)
{
    const BenchMachine &a = then.machine, &b = now.machine;
    if (a.processor != b.processor || a.cores != b.cores)
        return fmt::format("{} cores of {}, and {} of {} now", a.cores, a.processor, b.cores, b.processor);
    if (a.device != b.device || a.driver != b.driver)
        return fmt::format("{} with {}, and {} with {} now", a.device, a.driver, b.device, b.driver);
    return "";
}

const BenchResult* findResult(const BenchRecord& record, const std::string& name)
{
    const auto found = std::ranges::find(record.results, name, &BenchResult::name);
    return found == record.results.end() ? nullptr : &*found;
}

SpeedVerdict verdictOn(const Estimate& ratio, double limit)
{
    if (ratio.median > limit)
        return ratio.low > limit ? SpeedVerdict::slower : SpeedVerdict::perhapsSlower;
    return ratio.high < 1.0 / limit ? SpeedVerdict::faster : SpeedVerdict::asFast;
}

} // namespace

BenchMachine thisMachine(const gpu::DeviceDescription& device)
{
    return {.processor = lineOf("/proc/cpuinfo", "model name", ':', "a processor"),
            .cores = usableCores(),
            .system = lineOf("/etc/os-release", "PRETTY_NAME", '=', "Linux"),
            .device = device.name,
            .driver = device.driver + " " + device.driverVersion};
}

Json asJson(const Estimate& estimate, double unit)
{
    return Json::Object{{"median", estimate.median * unit},
                        {"low", estimate.low * unit},
                        {"high", estimate.high * unit},
                        {"count", estimate.count}};
}

Json::Object describedAsJson(const BenchRecord& record, std::string_view schema)
{
    return {
        {"schema", std::string(schema)},           {"program", record.program},       {"date", record.date},
        {"processor", record.machine.processor},   {"cores", record.machine.cores},   {"system", record.machine.system},
        {"device", record.machine.device},         {"driver", record.machine.driver}, {"clock", nameOf(record.clock)},
        {"start_up", phasesAsJson(record.startUp)}};
}

Json asJson(const BenchRecord& record)
{
    Json::Array results;
    for (const BenchResult& result : record.results)
        results.push_back(resultAsJson(result));
    Json::Object object = describedAsJson(record, kBenchSchema);
    object.emplace_back("results", results);
    object.emplace_back("peak_pss_mib", static_cast<double>(record.peakBytes) / kMebibyte);
    object.emplace_back("peak_rss_mib", static_cast<double>(record.peakResidentBytes) / kMebibyte);
    return object;
}

BenchRecord parseBenchRecord(std::string_view text, const std::string& file)
{
    const Json json = parseJson(text, file);
    const JsonView view(json, file);
    if (const std::string schema = view.member("schema").text(); schema != kBenchSchema)
        throw inputError(file, "/schema", "is " + schema + ", and this program reads " + std::string(kBenchSchema),
                         "measure again with --json");
    BenchRecord record;
    record.machine = {.processor = view.member("processor").text(),
                      .cores = wholeFrom(view.member("cores")),
                      .system = view.member("system").text(),
                      .device = view.member("device").text(),
                      .driver = view.member("driver").text()};
    record.clock = view.member("clock").text() == nameOf(BenchClock::wall) ? BenchClock::wall : BenchClock::processor;
    for (const JsonView& result : view.member("results").elements())
        record.results.push_back(resultFrom(result));
    return record;
}

void requireComparable(const BenchRecord& then, const std::string& file, const BenchRecord& now)
{
    if (const std::string other = machineDifference(then, now); !other.empty())
        throw inputError(file, "", "was measured on " + other, "compare times of one machine, device and driver");
    for (const BenchResult& result : now.results) {
        const BenchResult* const old = findResult(then, result.name);
        if (!old)
            throw inputError(file, "", "has no " + result.name, "measure the same scenes and settings");
        if (const std::string other = difference(*old, result); !other.empty())
            throw inputError(file, result.name, "was measured with " + other, "measure the same picture");
    }
}

std::vector<SpeedComparison> compareSpeed(const BenchRecord& then, const BenchRecord& now, double limit)
{
    std::vector<SpeedComparison> comparisons;
    for (const BenchResult& result : now.results) {
        const BenchResult* const old = findResult(then, result.name);
        assert(old);
        const Estimate ratio = ratioOf(old->of(now.clock), result.of(now.clock));
        comparisons.push_back({result.name, ratio, verdictOn(ratio, limit)});
    }
    return comparisons;
}

} // namespace torrance
