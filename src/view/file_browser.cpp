#include "view/file_browser.h"

#include "view/widgets.h"

#include <algorithm>
#include <cctype>
#include <imgui.h>

namespace torrance {
namespace {

constexpr std::size_t kMostEntries = 5000; // of a folder; more are not looked through by eye

std::string lowered(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

} // namespace

void FileBrowser::ask(Question q)
{
    question = std::move(q);
    open = true;
    overwrites = false;
    readFolder();
}

void FileBrowser::readFolder()
{
    entries.clear();
    problem.clear();
    std::error_code failure;
    auto iterator = std::filesystem::directory_iterator(folder, failure);
    if (failure) {
        problem = folder.string() + ": " + failure.message();
        return;
    }
    for (const auto end = std::filesystem::directory_iterator(); iterator != end && entries.size() < kMostEntries;
         iterator.increment(failure))
    {
        if (failure)
            break;
        std::error_code ignored;
        const Entry entry = {iterator->path().filename().string(), iterator->is_directory(ignored)};
        if (entry.name.starts_with('.'))
            continue;
        const std::string ending = lowered(iterator->path().extension().string());
        if (entry.isFolder || question.endings.empty() ||
            std::ranges::find(question.endings, ending) != question.endings.end())
            entries.push_back(entry);
    }
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
        return a.isFolder != b.isFolder ? a.isFolder : lowered(a.name) < lowered(b.name);
    });
}

void FileBrowser::choose(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (question.saves && !overwrites && std::filesystem::exists(path, ignored)) {
        overwrites = true;
        return;
    }
    open = false;
    question.chosen(path);
}

void FileBrowser::draw(const std::function<void(const std::string&)>& mark)
{
    if (!open)
        return;
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport.GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(viewport.Size.x * 0.8f, ImGui::GetFontSize() * 44.0f), viewport.Size.y * 0.7f},
                             ImGuiCond_Appearing);
    if (!ImGui::Begin((question.title + "###browser").c_str(), &open, ImGuiWindowFlags_NoCollapse)) {
        ImGui::End();
        return;
    }
    if (ImGui::Button("Up") && folder.has_parent_path()) {
        folder = folder.parent_path();
        readFolder();
    }
    ImGui::SameLine();
    std::string path = folder.string();
    ImGui::SetNextItemWidth(-1.0f);
    if (inputWhole("##folder", path)) {
        folder = path;
        readFolder();
    }
    mark("browser.folder");
    if (!problem.empty())
        note(problem);
    const float below = ImGui::GetFrameHeightWithSpacing() * (question.saves ? 3.0f : 1.5f);
    ImGui::BeginChild("entries", {0.0f, -below}, true);
    for (const Entry& entry : entries) {
        if (ImGui::Selectable((entry.isFolder ? entry.name + "/" : entry.name).c_str(), false,
                              ImGuiSelectableFlags_AllowDoubleClick))
        {
            if (entry.isFolder) {
                folder /= entry.name;
                readFolder();
                break; // the entries are others now
            }
            question.name = entry.name;
            overwrites = false;
            if (!question.saves || ImGui::IsMouseDoubleClicked(0)) {
                choose(folder / entry.name);
                break;
            }
        }
        mark("browser." + entry.name);
    }
    ImGui::EndChild();
    if (question.saves) {
        ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 12.0f);
        if (inputWhole("##name", question.name))
            overwrites = false;
        mark("browser.name");
        ImGui::SameLine();
        if (ImGui::Button(overwrites ? "Replace it" : "Save") && !question.name.empty())
            choose(folder / question.name);
        mark("browser.save");
        if (overwrites)
            note(question.name + " is there already");
    }
    if (ImGui::Button("Cancel"))
        open = false;
    ImGui::End();
}

} // namespace torrance
