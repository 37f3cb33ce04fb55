// A scene as it was read and as it was edited, as saving takes them.
#pragma once

#include "view/edits.h"

#include <filesystem>
#include <string>
#include <vector>

namespace torrance {

struct SceneToSave
{
    std::string input;                // as SceneOnDevice has it
    std::filesystem::path sourceCopy; // what its file held when it was read, once that is written over; else empty
    Scene original;                   // as its file was read
    Scene edited;
    std::vector<int> duplicateOf;                // by the materials that `edited` has beyond `original`
    std::vector<std::filesystem::path> pictures; // of the images that `edited` has beyond `original`
};

/// `scene` is what is shown, with `pictures` the files of the images that were added to it, each with one texture.
/// Those that no material reads any more (they were undone) are left out.
SceneToSave sceneToSave(const EditHistory& history, const Scene& scene,
                        const std::vector<std::filesystem::path>& pictures);

} // namespace torrance
