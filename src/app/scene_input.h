// Scenes as they are named on the command line.
#pragma once

#include <string>

namespace torrance {

/// `demo`, which comes with a camera of its own.
bool isBuiltInScene(const std::string& input);

/// The file of an input: `demo` is the built-in scene, anything else a path.
std::string sceneFile(const std::string& input);

} // namespace torrance
