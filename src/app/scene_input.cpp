#include "app/scene_input.h"

#include "core/data_folder.h"

namespace torrance {

std::string sceneFile(const std::string& input)
{
    return input == "demo" ? (dataFolder() / "assets" / "demo" / "demo.gltf").string() : input;
}

} // namespace torrance
