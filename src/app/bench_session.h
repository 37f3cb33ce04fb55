// What the three ways of `torrance bench` share.
#pragma once

#include "app/bench_options.h"
#include "app/command.h"
#include "gpu/shader_library.h"
#include "study/bench_record.h"
#include "study/growth_scenes.h"

#include <optional>
#include <string>
#include <vector>

namespace torrance {

struct BenchSession
{
    const BenchOptions& options;
    const GlobalOptions& global;
    std::vector<FrameVariant> variants;
    std::vector<PhaseTime> phases; // before what is timed
    std::optional<Environment> environment;
    gpu::Device device;
    gpu::ShaderLibrary shaders;
    BenchClock clock; // the processor's where it draws

    BenchSession(const BenchOptions& options, const GlobalOptions& global);

    /// Program, date, machine, clock and phases.
    BenchRecord emptyRecord() const;
    /// To standard output, unless the JSON goes there.
    void say(const std::string& text) const;
    /// To the file of --csv, where one was given.
    void writeCsv(const std::string& text) const;
};

/// Frames of the scenes in their variants.
ExitCode benchScenes(BenchSession& session);
/// What more of something costs.
ExitCode benchGrowth(BenchSession& session, const std::vector<const GrowthSeries*>& series);
/// Whole renders of the scenes in turn.
ExitCode benchSoak(BenchSession& session);

/// "all" or names separated by commas; Error (usage) for one that is not known.
std::vector<const GrowthSeries*> chosenGrowthSeries(const std::string& names);

} // namespace torrance
