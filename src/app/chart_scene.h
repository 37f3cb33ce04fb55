// `torrance chart SCENE`: whole plans of a scene.
#pragma once

#include "app/camera_options.h"
#include "app/chart_session.h"
#include "app/light_option.h"
#include "app/scene_input.h"

#include <filesystem>

namespace torrance {

struct SceneChartOptions
{
    std::string resolution; // empty: kChartResolution
    int directions = 256;
    std::string tolerances = "standard"; // names or shares, separated by commas
    SceneOptions scene;
    CameraOptions camera;
    LightOptions light;
};

inline constexpr const char* kChartResolution = "384x384";

void declareSceneChartOptions(CLI::App& app, SceneChartOptions& options);

/// Measures the plans of the one scene and writes plans.html, .svg, .csv and .json to the folder. What is finished is
/// kept in plans.part meanwhile.
void chartScene(const SceneChartOptions& options, const MeasuringOptions& measuring, const GlobalOptions& global,
                const std::filesystem::path& folder);

} // namespace torrance
