#include "app/bench_session.h"

#include "app/device_option.h"
#include "app/today.h"
#include "app/version.h"
#include "core/atomic_write.h"
#include "core/standard_output.h"
#include "gpu/shader_folder.h"

namespace torrance {
namespace {

template <typename Work>
auto timedPhase(std::vector<PhaseTime>& phases, const char* name, Work&& work)
{
    const TimeUse start = timeUse();
    auto result = work();
    phases.push_back({name, timeUse() - start});
    return result;
}

} // namespace

BenchSession::BenchSession(const BenchOptions& o, const GlobalOptions& g)
    : options(o), global(g), variants(frameVariants(o)),
      environment(timedPhase(phases, "environment",
                             [&] { return loadChosenEnvironment(o.environment, frameSettings(o.frame).methods); })),
      device(timedPhase(phases, "device", [&] { return openDevice(o.device, g); })),
      shaders(gpu::shaderFolder(), cacheFolder(g)),
      clock(device.description.isProcessor() ? BenchClock::processor : BenchClock::wall)
{
}

BenchRecord BenchSession::emptyRecord() const
{
    return {.program = versionText(),
            .date = today(),
            .machine = thisMachine(device.description),
            .clock = clock,
            .startUp = phases,
            .results = {},
            .peakBytes = 0,
            .peakResidentBytes = 0};
}

void BenchSession::say(const std::string& text) const
{
    if (global.json != "-")
        writeStandardOutput(text);
}

void BenchSession::writeCsv(const std::string& text) const
{
    if (!options.csv.empty())
        writeFile(options.csv, text);
}

} // namespace torrance
