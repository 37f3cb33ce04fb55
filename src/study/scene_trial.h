// One question to a picture: what it must do, and what it did.
#pragma once

#include "study/html_report.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace torrance {

struct SceneTrial
{
    std::string name;
    std::string expectation; // what the picture must do, and why
    std::string quantity;    // what was measured
    double measured = 0.0;
    double allowed = 0.0;
    bool applies = true; // false: the scene has nothing to ask of; `quantity` says what is missing
    std::vector<HtmlPicture> pictures;

    bool passed() const { return !applies || measured <= allowed; } // a NaN does not pass
};

/// Title, a table of all, then each with its pictures.
HtmlReport sceneTrialReport(const std::string& scene, const std::string& device, std::span<const SceneTrial> trials);

} // namespace torrance
