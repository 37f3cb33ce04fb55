#include "app/scene_input.h"

#include "core/data_folder.h"

namespace torrance {

bool isBuiltInScene(const std::string& input)
{
    return input == "demo";
}

std::string sceneFile(const std::string& input)
{
    return isBuiltInScene(input) ? (dataFolder() / "assets" / "demo" / "demo.gltf").string() : input;
}

} // namespace torrance
