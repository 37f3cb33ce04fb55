// Items that several panels have: numbers in double, colours as people know them, lists to choose from.
#pragma once

#include "math/vector.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace torrance {

bool sliderDouble(const char* label, double& value, double least, double greatest, const char* format = "%.3f",
                  int flags = 0); // of ImGuiSliderFlags
bool dragDouble(const char* label, double& value, double speed, double least, double greatest,
                const char* format = "%.3f");
bool dragPoint(const char* label, dvec3& value, double speed);

/// A scene-linear colour, chosen by its sRGB codes. Where it is not touched it keeps its bits.
bool colorLinear(const char* label, dvec3& value);

/// A text, selected whole when it is clicked: mostly it is replaced.
bool inputWhole(const char* label, std::string& value);

struct PanelContext;

/// One of a list; true where another was chosen. `tip` may explain an entry.
bool choose(const PanelContext& context, const char* label, const std::vector<std::string>& names, int& chosen,
            const std::function<std::string(int)>& tip = {});

/// Grey text that wraps.
void note(const std::string& text);

/// Shown beside the last item while the mouse is on it.
void tipOfItem(const std::string& text);

} // namespace torrance
