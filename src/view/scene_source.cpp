#include "view/scene_source.h"

#include "core/error.h"
#include "core/read_file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace torrance {
namespace {

ContentHash hashOf(const std::filesystem::path& file)
{
    return hashBytes(readFile(file.string()));
}

Error noCopy(const std::string& problem)
{
    return writeError(std::filesystem::temp_directory_path().string(),
                      "what the scene's file held cannot be kept there (" + problem + ")",
                      "name another folder with TMPDIR, or save to another file");
}

} // namespace

SceneSource::~SceneSource()
{
    removeCopy();
}

bool SceneSource::isFile(const std::filesystem::path& file) const
{
    std::error_code failure, ofOwn; // a file whose folder cannot be looked into is none that could be written over
    const std::filesystem::path there = std::filesystem::weakly_canonical(file, failure);
    return there == std::filesystem::weakly_canonical(own, ofOwn) && !failure && !ofOwn;
}

void SceneSource::makeCopy()
{
    std::string folder = (std::filesystem::temp_directory_path() / "torrance-XXXXXX").string();
    if (!mkdtemp(folder.data()))
        throw noCopy(std::strerror(errno));
    kept = std::filesystem::path(folder) / own.filename();
    std::error_code failure;
    if (!std::filesystem::copy_file(own, kept, failure)) {
        removeCopy();
        throw noCopy(failure.message());
    }
}

void SceneSource::removeCopy()
{
    std::error_code ignored; // a folder for temporary files is emptied by others, too
    if (!kept.empty())
        std::filesystem::remove_all(kept.parent_path(), ignored);
    kept.clear();
}

void SceneSource::writeOver(const std::function<void(const std::filesystem::path& copy)>& write)
{
    if (written && hashOf(own) != *written)
        throw inputError(own.string(), "", "was changed by another program since it was saved",
                         "save to another file, or load it again");
    if (!written)
        makeCopy();
    try {
        write(kept);
    } catch (...) {
        if (!written)
            removeCopy(); // the file still holds it, or what another program put there
        throw;
    }
    written = hashOf(own);
}

} // namespace torrance
