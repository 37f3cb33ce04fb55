#include "gpu/driver_environment.h"

#include "core/content_hash.h"

#include <cstdlib>
#include <fstream>
#include <string>

namespace torrance::gpu {
namespace {

// The processor's instruction sets decide the width of the code that the driver makes.
std::string processorType()
{
    std::ifstream info("/proc/cpuinfo");
    std::string line, text;
    while (std::getline(info, line) && !line.empty()) // the first processor's lines
        if (line.starts_with("flags") || line.starts_with("Features") || line.starts_with("vendor_id"))
            text += line;
    if (const char* width = std::getenv("LP_NATIVE_VECTOR_WIDTH"))
        text += width;
    return hashText(text).hex().substr(0, 16);
}

constexpr int kKeepTheUsers = 0;

void leaveOutDriversOfCards()
{
    constexpr const char* kDisable = "VK_LOADER_DRIVERS_DISABLE";
    constexpr const char* kDrivers = "*intel*,*radeon*,*nouveau*,*asahi*,*freedreno*,*broadcom*,*panfrost*,*powervr*,"
                                     "*virtio*"; // names of their manifests
    std::error_code failure;
    if (std::filesystem::exists("/dev/dri", failure) || failure)
        return;
    for (const char* choice : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_LOADER_DRIVERS_SELECT", kDisable})
        if (std::getenv(choice))
            return;
    setenv(kDisable, kDrivers, kKeepTheUsers);
}

} // namespace

void prepareDriverEnvironment(const std::filesystem::path& cacheFolder)
{
    leaveOutDriversOfCards();
    setenv("GALLIVM_PERF", "no_aos_sampling", kKeepTheUsers);
    if (cacheFolder.empty()) {
        setenv("MESA_SHADER_CACHE_DISABLE", "true", kKeepTheUsers);
        return;
    }
    const std::filesystem::path folder = cacheFolder / ("mesa-" + processorType());
    std::error_code failure;
    std::filesystem::create_directories(folder, failure); // Mesa makes no parents
    if (failure) // Mesa would say so in words of its own, and one warning is enough
        setenv("MESA_SHADER_CACHE_DISABLE", "true", kKeepTheUsers);
    else
        setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), kKeepTheUsers);
}

std::filesystem::path driverCacheFolder()
{
    const char* folder = std::getenv("MESA_SHADER_CACHE_DIR");
    return folder ? std::filesystem::path(folder) / "mesa_shader_cache" : std::filesystem::path();
}

} // namespace torrance::gpu
