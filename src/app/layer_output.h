// Surface parameters beside the picture: layers of an EXR, or EXR files of their own.
#pragma once

#include "files/image_write.h"
#include "passes/renderer.h"

#include <string>
#include <vector>

namespace torrance {

/// The layers named by --aov ("all", or names separated by commas) out of what was drawn.
std::vector<ImageLayer> chosenLayers(const std::string& names, const Picture& picture);

/// Throws Error (usage) with the nearest of `known` where --aov names no layer.
void checkLayerNames(const std::string& names, const std::vector<std::string>& known);

/// Writes the picture with its layers: inside an EXR; beside any other file FILE.EXT each as FILE.LAYER.exr. Standard
/// output takes no layers. Returns the names of the files.
std::vector<std::string> writeWithLayers(const std::string& output, const Picture& picture,
                                         const std::string& layerNames, const WriteSettings& settings);

} // namespace torrance
