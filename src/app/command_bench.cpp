#include "app/command_bench.h"

#include "app/bench_session.h"

namespace torrance {
namespace {

ExitCode run(const BenchOptions& options, const GlobalOptions& global)
{
    checkBenchOptions(options);
    const std::vector<const GrowthSeries*> series = chosenGrowthSeries(options.growth);
    if (series.empty())
        sceneInputs(options.scene); // that there is one
    BenchSession session(options, global);
    if (!series.empty())
        return benchGrowth(session, series);
    return options.soak > 0 ? benchSoak(session) : benchScenes(session);
}

} // namespace

Command benchCommand()
{
    return makeCommand<BenchOptions>("bench", "Measure what frames cost, and how sure that is", declareBenchOptions,
                                     run);
}

} // namespace torrance
