#include "view/widgets.h"

#include "image/srgb.h"
#include "view/panels.h"

#include <imgui.h>
#include <imgui_stdlib.h>

namespace torrance {

bool sliderDouble(const char* label, double& value, double least, double greatest, const char* format, int flags)
{
    return ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &least, &greatest, format,
                               flags | ImGuiSliderFlags_AlwaysClamp);
}

bool dragDouble(const char* label, double& value, double speed, double least, double greatest, const char* format)
{
    return ImGui::DragScalar(label, ImGuiDataType_Double, &value, static_cast<float>(speed), &least, &greatest, format,
                             ImGuiSliderFlags_AlwaysClamp);
}

bool dragPoint(const char* label, dvec3& value, double speed)
{
    return ImGui::DragScalarN(label, ImGuiDataType_Double, &value.x, 3, static_cast<float>(speed), nullptr, nullptr,
                              "%.3f");
}

bool colorLinear(const char* label, dvec3& value)
{
    vec3 encoded;
    for (int i = 0; i < 3; ++i)
        encoded[i] = static_cast<float>(srgbEncode(value[i]));
    if (!ImGui::ColorEdit3(label, &encoded.x))
        return false;
    for (int i = 0; i < 3; ++i)
        value[i] = srgbDecode(static_cast<double>(encoded[i]));
    return true;
}

bool inputWhole(const char* label, std::string& value)
{
    return ImGui::InputText(label, &value, ImGuiInputTextFlags_AutoSelectAll);
}

bool choose(const PanelContext& context, const char* label, const std::vector<std::string>& names, int& chosen,
            const std::function<std::string(int)>& tip)
{
    const bool known = chosen >= 0 && static_cast<std::size_t>(chosen) < names.size();
    bool changed = false;
    if (!ImGui::BeginCombo(label, known ? names[static_cast<std::size_t>(chosen)].c_str() : ""))
        return false;
    for (int i = 0; i < static_cast<int>(names.size()); ++i) {
        ImGui::PushID(i);
        if (ImGui::Selectable(names[static_cast<std::size_t>(i)].c_str(), i == chosen) && i != chosen) {
            chosen = i;
            changed = true;
        }
        context.mark("entry." + names[static_cast<std::size_t>(i)]);
        if (tip && ImGui::IsItemHovered())
            tipOfItem(tip(i));
        ImGui::PopID();
    }
    ImGui::EndCombo();
    return changed;
}

void note(const std::string& text)
{
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

void tipOfItem(const std::string& text)
{
    if (!ImGui::IsItemHovered() || text.empty())
        return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 30.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

} // namespace torrance
