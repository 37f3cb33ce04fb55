// What the loader and software drivers read from the environment when an instance is made.
#pragma once

#include <filesystem>

namespace torrance::gpu {

/// Sets, unless the user has set them:
/// - GALLIVM_PERF=no_aos_sampling: lavapipe then filters 8-bit textures in float instead of 8-bit fixed point;
/// - MESA_SHADER_CACHE_DIR: a folder of its own per processor type below `cacheFolder`. Mesa's key holds the driver's
///   build but not the vector width, and code of another width ends the process (rc 134);
/// - VK_LOADER_DRIVERS_DISABLE: Mesa's drivers of cards, where there is no /dev/dri, through which alone they reach
/// any.
///   Opening them took a tenth of a warm picture's start. Who chooses drivers by any of the loader's variables is left
///   alone;
/// - with a `cacheFolder` that is empty or cannot be made, MESA_SHADER_CACHE_DISABLE=true.
/// To be called before threads are started, before the first Device.
void prepareDriverEnvironment(const std::filesystem::path& cacheFolder);

/// Where the driver keeps what it compiles, after prepareDriverEnvironment; empty where it keeps nothing or is not
/// Mesa's.
std::filesystem::path driverCacheFolder();

} // namespace torrance::gpu
