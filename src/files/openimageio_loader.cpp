#include "files/openimageio_loader.h"

#include "core/error.h"
#include "files/image_limits.h"
#include "files/openimageio/interface.h"

#include <dlfcn.h>
#include <filesystem>
#include <sstream>

namespace torrance {
namespace {

struct Module
{
    TorranceOiioRead read = nullptr;
    TorranceOiioRelease release = nullptr;
};

// Beside bin, as the program's data; never from the working directory or the search path.
std::filesystem::path modulePath()
{
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    return program.parent_path().parent_path() / "lib" / "torrance" / "torrance_openimageio.so";
}

// Never closed: its 261 libraries are not made to be.
Module openModule()
{
    Module module;
    if (void* handle = dlopen(modulePath().c_str(), RTLD_LAZY | RTLD_LOCAL)) {
        module.read = reinterpret_cast<TorranceOiioRead>(dlsym(handle, kOiioReadName));
        module.release = reinterpret_cast<TorranceOiioRelease>(dlsym(handle, kOiioReleaseName));
    }
    return module;
}

std::vector<std::string> lines(const char* text)
{
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        result.push_back(line);
    return result;
}

} // namespace

ReadImage readThroughOpenImageIo(const std::string& path)
{
    static const Module module = openModule();
    if (module.read == nullptr || module.release == nullptr)
        throw inputError(path, "", "is neither PNG, JPEG, WebP, HDR nor EXR, and there is no OpenImageIO to read it",
                         "convert it, or install libopenimageio-dev and build Torrance again");
    TorranceOiioPicture picture = {};
    char problem[256] = "";
    if (module.read(path.c_str(), {.side = kMaxImageSide, .values = kMaxImageValues}, &picture, problem,
                    sizeof problem) != 0)
        throw inputError(path, "", problem, "name a picture that can be read");
    ReadImage result{.image = Image(picture.width, picture.height, picture.channels),
                     .displayReferred = picture.displayReferred != 0,
                     .channelNames = lines(picture.channelNames)};
    result.image.texels.assign(picture.texels, picture.texels + result.image.texels.size());
    module.release(&picture);
    return result;
}

} // namespace torrance
