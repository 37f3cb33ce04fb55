// The device that a command works on, and the folder in which what it makes is kept.
#pragma once

#include "app/command.h"
#include "gpu/device.h"

#include <filesystem>
#include <future>
#include <string>

namespace torrance {

void declareDeviceOption(CLI::App& app, std::string& choice);

/// The user's cache folder; empty with --no-cache.
std::filesystem::path cacheFolder(const GlobalOptions& global);

/// Sets what drivers read from the environment, then opens the device; an Error (noDevice) where `validation` asks for
/// a layer that is not there.
gpu::Device openDevice(const std::string& choice, const GlobalOptions& global, bool validation = false);

/// The same in two steps: a thread of its own opens the device while the caller does something else.
std::future<gpu::Device> startOpeningDevice(const std::string& choice, const GlobalOptions& global,
                                            bool validation = false);
gpu::Device finishOpeningDevice(std::future<gpu::Device> opening);

} // namespace torrance
