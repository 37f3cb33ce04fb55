#include "view/file_browser.h"

#include "view/panels.h"
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

void FileBrowser::goTo(const std::filesystem::path& path)
{
    folder = path;
    readFolder();
}

void FileBrowser::drawEntries(const PanelContext& context)
{
    for (const Entry& entry : entries) {
        const bool chosen =
            ImGui::Selectable((entry.isFolder ? entry.name + "/" : entry.name).c_str(),
                              question.saves && entry.name == question.name, ImGuiSelectableFlags_AllowDoubleClick);
        context.mark("browser." + entry.name);
        if (!chosen)
            continue;
        if (entry.isFolder)
            return goTo(folder / entry.name); // the entries are others now
        question.name = entry.name;
        overwrites = false;
        if (!question.saves || ImGui::IsMouseDoubleClicked(0))
            return choose(folder / entry.name);
    }
}

void FileBrowser::drawName(const PanelContext& context)
{
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Name");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 8.0f);
    if (inputWhole("##name", question.name))
        overwrites = false;
    const bool entered = ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter));
    context.mark("browser.name");
    ImGui::SameLine();
    const bool pressed = ImGui::Button(overwrites ? "Replace it" : "Save");
    context.mark("browser.save");
    if ((pressed || entered) && !question.name.empty())
        choose(folder / question.name);
    if (overwrites)
        note(question.name + " is there already");
}

void FileBrowser::draw(const PanelContext& context)
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
    context.markWindow("dialog.browser");
    if (ImGui::Button("Up") && folder.has_parent_path())
        goTo(folder.parent_path());
    context.mark("browser.up");
    ImGui::SameLine();
    std::string path = folder.string();
    ImGui::SetNextItemWidth(-1.0f);
    if (inputWhole("##folder", path))
        goTo(path);
    context.mark("browser.folder");
    if (!problem.empty())
        note(problem);
    const float below = ImGui::GetFrameHeightWithSpacing() * (question.saves ? 3.0f : 1.5f);
    ImGui::BeginChild("entries", {0.0f, -below}, true);
    if (entries.empty() && problem.empty())
        note("There is nothing here that could be chosen.");
    drawEntries(context);
    ImGui::EndChild();
    if (question.saves)
        drawName(context);
    if (ImGui::Button("Cancel"))
        open = false;
    context.mark("browser.cancel");
    ImGui::End();
}

} // namespace torrance
