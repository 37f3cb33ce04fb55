// What `torrance bench` is asked for.
#pragma once

#include "app/camera_options.h"
#include "app/environment_option.h"
#include "app/frame_options.h"
#include "app/light_option.h"
#include "app/scene_input.h"
#include "study/bench_frames.h"
#include "study/bench_item.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace torrance {

struct BenchOptions
{
    int frames = 0;
    std::optional<double> seconds;
    std::vector<std::string> vary; // "OPTION=VALUE,VALUE"
    std::string against;           // file; empty: none
    std::optional<double> limit;
    std::string growth; // "all" or names; empty: scenes
    int soak = 0;       // renders; 0: scenes
    std::string csv;
    std::string device;
    SceneOptions scene;
    FrameOptions frame;
    CameraOptions camera;
    EnvironmentOptions environment;
    LightOptions light;
};

void declareBenchOptions(CLI::App& app, BenchOptions& options);

/// Error (usage) for options that would have no effect.
void checkBenchOptions(const BenchOptions& options);

/// A frame of the command line's or, with --vary, one of several, and what makes it another: "path=prepass".
struct FrameVariant
{
    std::string name; // empty where nothing is varied
    FrameOptions frame;
};

/// Every combination of the values that --vary lists, the first value of each first. Error (usage) for an option that
/// frames do not have and for a value that it does not take.
std::vector<FrameVariant> frameVariants(const BenchOptions& options);

/// --frames, and --seconds or `seconds`.
BenchBounds boundsOf(const BenchOptions& options, double seconds);

inline constexpr double kFrameSeconds = 20.0;  // for each picture, unless others are given
inline constexpr double kGrowthSeconds = 60.0; // for each size

/// The pictures of all scenes in all variants, with `environment` about them, as render draws them.
std::vector<BenchSource> benchSources(const BenchOptions& options, const std::vector<FrameVariant>& variants,
                                      const std::optional<Environment>& environment);

} // namespace torrance
