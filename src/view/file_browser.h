// A dialog that chooses a file: the desktops' own would bring some forty packages.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace torrance {

struct PanelContext;

class FileBrowser
{
public:
    /// Shows the files of `folder` that end in one of `endings` (lower case, with the dot; none: all). `chosen` is
    /// called with what was picked or, where `saves`, typed.
    struct Question
    {
        std::string title;
        std::vector<std::string> endings;
        bool saves = false;
        std::string name; // offered where it saves
        std::function<void(const std::filesystem::path&)> chosen;
    };
    void ask(Question question);
    bool isOpen() const { return open; }
    void close() { open = false; } // nothing is chosen

    void setFolder(const std::filesystem::path& path) { folder = path; }

    /// To be called once for each picture of the window.
    void draw(const PanelContext& context);

private:
    struct Entry
    {
        std::string name;
        bool isFolder = false;
    };
    void drawEntries(const PanelContext& context);
    void drawName(const PanelContext& context);
    void goTo(const std::filesystem::path& path);
    void readFolder();
    void choose(const std::filesystem::path& path);

    Question question;
    bool open = false;
    std::filesystem::path folder = std::filesystem::current_path();
    std::string problem;
    std::vector<Entry> entries;
    bool overwrites = false; // asked once more before a file is replaced
};

} // namespace torrance
