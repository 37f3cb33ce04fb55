#include "view/kept_settings.h"

#include "core/atomic_write.h"
#include "core/error.h"
#include "core/log.h"
#include "core/read_file.h"
#include "core/user_folder.h"
#include "files/json_parse.h"

#include <algorithm>
#include <functional>

namespace torrance {
namespace {

constexpr const char *kRecentFile = "recent.json", *kSettingsFile = "settings.json";
constexpr double kLeastWindow = 64.0, kMostWindow = 16384.0; // a side

// Nothing where there is no such file; one that is damaged is warned of, and `take` may have taken a part.
void readKept(const std::filesystem::path& file, const std::function<void(const JsonView&)>& take)
{
    std::error_code failure;
    if (!std::filesystem::is_regular_file(file, failure))
        return;
    try {
        const std::vector<std::byte> bytes = readFile(file.string());
        const Json json = parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file.string());
        take(JsonView(json, file.string()));
    } catch (const Error& error) {
        logWarning(error.what());
    }
}

void writeKept(const std::filesystem::path& folder, const char* name, const Json& json)
{
    if (folder.empty())
        return;
    try {
        std::error_code ignored; // writing says what is wrong
        std::filesystem::create_directories(folder, ignored);
        writeFile((folder / name).string(), jsonText(json));
    } catch (const Error& error) {
        logWarning(error.what());
    }
}

template <typename Number>
void takeNumber(const JsonView& json, Number& value, double least, double greatest)
{
    const double number = json.number();
    if (number >= least && number <= greatest)
        value = static_cast<Number>(number);
}

} // namespace

std::filesystem::path userConfigFolder()
{
    return userFolder("XDG_CONFIG_HOME", ".config");
}

std::vector<std::string> loadRecent(const std::filesystem::path& configFolder)
{
    std::vector<std::string> recent;
    if (!configFolder.empty())
        readKept(configFolder / kRecentFile, [&](const JsonView& json) {
            std::vector<std::string> read;
            for (const JsonView& entry : json.member("recent").elements())
                read.push_back(entry.text());
            recent = std::move(read);
        });
    recent.resize(std::min(recent.size(), kMostRecent));
    return recent;
}

std::vector<std::string> keepRecent(const std::filesystem::path& configFolder, std::vector<std::string> recent,
                                    const std::string& file)
{
    const std::string path = std::filesystem::absolute(file).string();
    std::erase(recent, path);
    recent.insert(recent.begin(), path);
    recent.resize(std::min(recent.size(), kMostRecent));
    writeKept(configFolder, kRecentFile, Json::Object{{"recent", Json::Array(recent.begin(), recent.end())}});
    return recent;
}

KeptSettings loadSettings(const std::filesystem::path& configFolder)
{
    KeptSettings settings;
    if (!configFolder.empty())
        readKept(configFolder / kSettingsFile, [&](const JsonView& json) {
            KeptSettings read;
            takeNumber(json.member("width"), read.windowSize.x, kLeastWindow, kMostWindow);
            takeNumber(json.member("height"), read.windowSize.y, kLeastWindow, kMostWindow);
            read.showPanels = json.member("panels").boolean();
            takeNumber(json.member("turntable_frames"), read.turntableFrames, kLeastTurntableFrames,
                       kMostTurntableFrames);
            takeNumber(json.member("tolerance"), read.tolerance, kLeastTolerance, kMostTolerance);
            takeNumber(json.member("lamp_speed"), read.lampSpeed, -kMostLampSpeed, kMostLampSpeed);
            if (read.windowSize.x == 0 || read.windowSize.y == 0)
                read.windowSize = ivec2(0);
            settings = read;
        });
    return settings;
}

void keepSettings(const std::filesystem::path& configFolder, const KeptSettings& settings)
{
    writeKept(configFolder, kSettingsFile,
              Json::Object{{"width", settings.windowSize.x},
                           {"height", settings.windowSize.y},
                           {"panels", settings.showPanels},
                           {"turntable_frames", settings.turntableFrames},
                           {"tolerance", settings.tolerance},
                           {"lamp_speed", settings.lampSpeed}});
}

} // namespace torrance
