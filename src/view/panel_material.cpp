#include "scene/named_material.h"
#include "view/edit_scope.h"
#include "view/file_browser.h"
#include "view/panels.h"
#include "view/thumbnails.h"
#include "view/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

namespace torrance {
namespace {

std::string nameOf(const Material& material, std::size_t index)
{
    return material.name.empty() ? fmt::format("material {}", index) : material.name;
}

void drawList(const PanelContext& context, const std::vector<Material>& materials)
{
    ViewerState& state = context.state;
    ImGui::BeginChild("materials", {0.0f, context.unit * 6.0f}, true);
    for (std::size_t i = 0; i < materials.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(nameOf(materials[i], i).c_str(), static_cast<int>(i) == state.selectedMaterial))
            state.selectedMaterial = static_cast<int>(i);
        ImGui::PopID();
        context.mark(fmt::format("material.list.{}", i));
    }
    ImGui::EndChild();
}

void drawNames(const PanelContext& context, EditScope& edit, Material& material)
{
    edit.after(inputWhole("name", material.name));
    context.mark("material.name");
    const auto known = namedMaterials();
    std::vector<std::string> names;
    for (const NamedMaterial& named : known)
        names.emplace_back(named.name);
    int chosen = -1;
    if (choose(context, "make it", names, chosen)) {
        const Material pure = materialOf(known[static_cast<std::size_t>(chosen)]);
        material.baseColorFactor = pure.baseColorFactor;
        material.metallicFactor = pure.metallicFactor;
        material.ior = pure.ior;
        edit.finish();
    }
    context.mark("material.named");
    tipOfItem("Base colour, metallic and index of refraction of a real material; textures are kept.");
}

void askForTexture(const PanelContext& context, TextureUse Material::*role)
{
    ViewerState& state = context.state;
    context.browser.ask(
        {.title = "Choose a texture",
         .endings = {".png", ".jpg", ".jpeg", ".webp"},
         .saves = false,
         .name = {},
         .chosen = [&state, role, material = state.selectedMaterial](const std::filesystem::path& path) {
             state.requests.push_back(OpenTexture{path.string(), material, role});
         }});
}

void drawThumbnail(const PanelContext& context, const TextureUse& use)
{
    const Scene& scene = context.state.scene->scene();
    const int image = scene.textures[static_cast<std::size_t>(use.texture)].image;
    const TextureImage& source = scene.images[static_cast<std::size_t>(image)];
    if (const gpu::DeviceImage* picture = context.thumbnails.get(scene, image)) {
        const float side = context.unit * 2.5f;
        ImGui::Image(const_cast<gpu::DeviceImage*>(picture), {side, side}); // ImGui writes nothing to it
        tipOfItem(fmt::format("{}, {} x {}", source.name, source.width, source.height));
        ImGui::SameLine();
    }
}

void drawTexture(const PanelContext& context, EditScope& edit, const char* what, TextureUse Material::*role)
{
    ViewerState& state = context.state;
    TextureUse& use = edit.edits.materials[static_cast<std::size_t>(state.selectedMaterial)].*role;
    ImGui::PushID(what);
    if (use.used())
        drawThumbnail(context, use);
    ImGui::BeginGroup();
    ImGui::TextUnformatted(what);
    if (ImGui::SmallButton(use.used() ? "another ..." : "choose a picture ..."))
        askForTexture(context, role);
    context.mark(fmt::format("material.choose.{}", what));
    if (use.used()) {
        ImGui::SameLine();
        if (ImGui::SmallButton("take off")) {
            use = {};
            edit.finish();
        }
        context.mark(fmt::format("material.takeOff.{}", what));
    }
    ImGui::EndGroup();
    ImGui::PopID();
}

void drawFactors(const PanelContext& context, EditScope& edit, Material& material)
{
    dvec3 base(material.baseColorFactor);
    const bool baseChanged = colorLinear("base colour", base);
    material.baseColorFactor = dvec4(base, material.baseColorFactor.w);
    edit.after(baseChanged);
    context.mark("material.baseColor");
    edit.after(sliderDouble("metallic", material.metallicFactor, 0.0, 1.0));
    context.mark("material.metallic");
    edit.after(sliderDouble("roughness", material.roughnessFactor, 0.0, 1.0));
    context.mark("material.roughness");
    edit.after(sliderDouble("index of refraction", material.ior, 1.0, 3.0));
    context.mark("material.ior");
    dvec3 emissive = material.emissiveFactor;
    const double strength = std::max({1.0, emissive.x, emissive.y, emissive.z});
    dvec3 color = emissive / strength;
    if (colorLinear("emission", color))
        material.emissiveFactor = color * strength, edit.after(true);
    else
        edit.after(false);
    context.mark("material.emission");
    if (emissive != dvec3(0.0)) {
        double chosen = strength;
        if (dragDouble("strength", chosen, 0.05, 1.0, 1e6)) {
            material.emissiveFactor = emissive / strength * chosen;
            edit.after(true);
        } else
            edit.after(false);
    }
    if (material.normal.used())
        edit.after(sliderDouble("normal scale", material.normalScale, 0.0, 2.0));
    if (material.occlusion.used())
        edit.after(sliderDouble("occlusion", material.occlusionStrength, 0.0, 1.0));
}

void drawModes(const PanelContext& context, EditScope& edit, Material& material)
{
    int mode = static_cast<int>(material.alphaMode);
    if (choose(context, "alpha", {"opaque", "mask", "blend"}, mode)) {
        material.alphaMode = static_cast<AlphaMode>(mode);
        edit.finish();
    }
    context.mark("material.alphaMode");
    if (material.alphaMode != AlphaMode::opaque)
        edit.after(sliderDouble("opacity", material.baseColorFactor.w, 0.0, 1.0));
    if (material.alphaMode == AlphaMode::mask)
        edit.after(sliderDouble("cutoff", material.alphaCutoff, 0.0, 1.0));
    if (ImGui::Checkbox("double sided", &material.doubleSided))
        edit.finish();
    ImGui::SameLine();
    if (ImGui::Checkbox("unlit", &material.unlit))
        edit.finish();
    context.mark("material.unlit");
}

void drawButtons(const PanelContext& context, EditScope& edit)
{
    ViewerState& state = context.state;
    if (ImGui::Button("Duplicate")) {
        Material copy = edit.edits.materials[static_cast<std::size_t>(state.selectedMaterial)];
        copy.name = nameOf(copy, static_cast<std::size_t>(state.selectedMaterial)) + " copy";
        edit.edits.materials.push_back(copy);
        edit.edits.duplicateOf.push_back(state.selectedMaterial);
        state.selectedMaterial = static_cast<int>(edit.edits.materials.size()) - 1;
        edit.finish();
    }
    context.mark("material.duplicate");
    ImGui::SameLine();
    if (ImGui::Button("To a file ..."))
        context.browser.ask({.title = "Save the material",
                             .endings = {".gltf"},
                             .saves = true,
                             .name = "material.gltf",
                             .chosen = [&state, material = state.selectedMaterial](const std::filesystem::path& path) {
                                 state.requests.push_back(SaveMaterial{path.string(), material});
                             }});
    context.mark("material.toFile");
    ImGui::SameLine();
    if (ImGui::Button("From a file ..."))
        context.browser.ask({.title = "Take over a material; textures are kept",
                             .endings = {".gltf", ".glb"},
                             .saves = false,
                             .name = {},
                             .chosen = [&state, material = state.selectedMaterial](const std::filesystem::path& path) {
                                 state.requests.push_back(OpenMaterial{path.string(), material});
                             }});
    context.mark("material.fromFile");
    if (state.selectedInstance < 0)
        return;
    const Instance& instance = state.scene->scene().instances[static_cast<std::size_t>(state.selectedInstance)];
    int& place = edit.edits.primitiveMaterials[static_cast<std::size_t>(instance.primitive)];
    if (place == state.selectedMaterial)
        note("on the selected object");
    else if (ImGui::Button("Give it to the selected object")) {
        place = state.selectedMaterial;
        edit.finish();
    }
    context.mark("material.assign");
}

} // namespace

void drawMaterialPanel(const PanelContext& context)
{
    ViewerState& state = context.state;
    EditScope edit(state);
    std::vector<Material>& materials = edit.edits.materials;
    if (materials.empty()) {
        note("The file has no materials: glTF's default one is drawn.");
        return;
    }
    drawList(context, materials);
    if (state.selectedMaterial < 0 || static_cast<std::size_t>(state.selectedMaterial) >= materials.size()) {
        note("Click an object in the picture, or a material above.");
        return;
    }
    Material& material = materials[static_cast<std::size_t>(state.selectedMaterial)];
    ImGui::PushID(state.selectedMaterial);
    drawNames(context, edit, material);
    drawFactors(context, edit, material);
    drawModes(context, edit, material);
    const bool open = ImGui::TreeNode("textures");
    context.mark("material.textures");
    if (open) {
        drawTexture(context, edit, "base colour", &Material::baseColor);
        drawTexture(context, edit, "metallic, roughness", &Material::metallicRoughness);
        drawTexture(context, edit, "normal", &Material::normal);
        drawTexture(context, edit, "occlusion", &Material::occlusion);
        drawTexture(context, edit, "emission", &Material::emissive);
        ImGui::TreePop();
    }
    drawButtons(context, edit);
    ImGui::PopID();
}

} // namespace torrance
