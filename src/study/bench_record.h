// What `torrance bench` measured, as a file holds it, and two such files held against each other.
#pragma once

#include "files/json_write.h"
#include "measure/timing_statistics.h"
#include "study/bench_frames.h"
#include "study/bench_item.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace torrance {

/// What times can be compared on.
struct BenchMachine
{
    std::string processor;
    int cores = 0; // that this process may use
    std::string system;
    std::string device;
    std::string driver; // name and version
};

/// The processor's and the system's names as they give them themselves.
BenchMachine thisMachine(const gpu::DeviceDescription& device);

struct BenchPass
{
    std::string name;
    Estimate processor; // seconds
    Estimate wall;
};

struct BenchResult
{
    std::string name;
    int width = 0;
    int height = 0;
    int samples = 1;
    std::string path;    // of rendering: may differ between what is compared
    std::string methods; // ids, of every slot
    std::size_t triangles = 0;
    std::size_t draws = 0;
    std::size_t pipelines = 0;
    Estimate processor; // seconds a frame
    Estimate wall;
    bool settled = false;          // as narrow as was asked for
    std::optional<Estimate> ratio; // to the first result, by the clock that decides
    std::vector<BenchPass> passes;
    std::vector<PhaseTime> startUp;
    std::uint64_t heldBytes = 0;

    const Estimate& of(BenchClock clock) const { return clock == BenchClock::wall ? wall : processor; }
};

struct BenchRecord
{
    std::string program; // version and build
    std::string date;
    BenchMachine machine;
    BenchClock clock = BenchClock::processor;
    std::vector<PhaseTime> startUp; // before the first result: environment, device
    std::vector<BenchResult> results;
    std::uint64_t peakBytes = 0;         // PSS, as sampled
    std::uint64_t peakResidentBytes = 0; // with all that is shared
};

inline constexpr std::string_view kBenchSchema = "torrance-bench/1";

/// Times in milliseconds, memory in MiB.
Json asJson(const BenchRecord& record);
Json asJson(const Estimate& estimate, double unit);
/// Schema, program, date, machine, clock and start-up: how every file of `torrance bench` begins.
Json::Object describedAsJson(const BenchRecord& record, std::string_view schema);

/// The parts of a record that times are compared by: machine, clock, and of the results all but passes, start-up and
/// memory. Errors (input) name `file`: damaged, of another schema, a member missing or of another kind.
BenchRecord parseBenchRecord(std::string_view text, const std::string& file);

enum class SpeedVerdict
{
    asFast,
    faster,
    slower,        // the whole interval of the ratio lies above the limit
    perhapsSlower, // the ratio does, its interval not
};

struct SpeedComparison
{
    std::string name;
    Estimate ratio; // of now to then
    SpeedVerdict verdict = SpeedVerdict::asFast;
};

/// An Error (input) names `file`, that of `then`, where times of `now` cannot be compared with it: another machine,
/// device or driver, no result of a name of `now`, or one of another size, other samples, methods or triangles. Nothing
/// of `now` is read that is measured.
void requireComparable(const BenchRecord& then, const std::string& file, const BenchRecord& now);

/// Each result of `now` against the one of its name; limit >= 1. The two are comparable.
std::vector<SpeedComparison> compareSpeed(const BenchRecord& then, const BenchRecord& now, double limit);

} // namespace torrance
