#include "view/kept_settings.h"

#include "core/atomic_write.h"
#include "core/error.h"
#include "core/log.h"
#include "core/read_file.h"
#include "files/json_parse.h"

#include <algorithm>
#include <cstdlib>

namespace torrance {
namespace {

std::filesystem::path recentFile(const std::filesystem::path& folder)
{
    return folder / "recent.json";
}

} // namespace

std::filesystem::path userConfigFolder()
{
    if (const char* folder = std::getenv("XDG_CONFIG_HOME"); folder && *folder)
        return std::filesystem::path(folder) / "torrance";
    if (const char* home = std::getenv("HOME"); home && *home)
        return std::filesystem::path(home) / ".config" / "torrance";
    return {};
}

std::vector<std::string> loadRecent(const std::filesystem::path& configFolder)
{
    std::error_code failure;
    const std::filesystem::path file = recentFile(configFolder);
    if (configFolder.empty() || !std::filesystem::is_regular_file(file, failure))
        return {};
    try {
        const std::vector<std::byte> bytes = readFile(file.string());
        const Json json = parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file.string());
        std::vector<std::string> recent;
        for (const JsonView& entry : JsonView(json, file.string()).member("recent").elements())
            recent.push_back(entry.text());
        recent.resize(std::min(recent.size(), kMostRecent));
        return recent;
    } catch (const Error& error) {
        logWarning(error.what());
        return {};
    }
}

std::vector<std::string> keepRecent(const std::filesystem::path& configFolder, std::vector<std::string> recent,
                                    const std::string& file)
{
    const std::string path = std::filesystem::absolute(file).string();
    std::erase(recent, path);
    recent.insert(recent.begin(), path);
    recent.resize(std::min(recent.size(), kMostRecent));
    if (configFolder.empty())
        return recent;
    try {
        std::error_code ignored; // writing says what is wrong
        std::filesystem::create_directories(configFolder, ignored);
        writeFile(recentFile(configFolder),
                  jsonText(Json::Object{{"recent", Json::Array(recent.begin(), recent.end())}}));
    } catch (const Error& error) {
        logWarning(error.what());
    }
    return recent;
}

} // namespace torrance
