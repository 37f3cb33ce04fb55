// Where edits go that were not saved when the window cannot go on.
#pragma once

#include <filesystem>
#include <string>

namespace torrance {

/// $XDG_STATE_HOME/torrance, else ~/.local/state/torrance; empty where neither is set.
std::filesystem::path userStateFolder();

/// A name in the folder, which is made, that no file has yet: "<name of the input>-unsaved.glb", and with -2, -3 after
/// that. A .glb holds its buffers and pictures: it can be opened wherever it lies. Errors (cannotWrite): the folder is
/// empty or cannot be made.
std::filesystem::path recoveryFile(const std::filesystem::path& stateFolder, const std::string& input);

} // namespace torrance
