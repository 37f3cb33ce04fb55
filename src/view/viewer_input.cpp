// What the mouse and the keys do in the picture.
#include "view/viewer.h"

#include "scene/camera_view.h"
#include "view/camera_steps.h"
#include "view/lamp_turning.h"
#include "view/screen_place.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace torrance {
namespace {

constexpr double kDegreesAcross = 180.0; // that a drag over the whole height turns by
constexpr double kLongestTurn =
    0.25; // seconds of a lamp's way in one picture: after a pause it goes on, and does not jump
constexpr float kClickPixels = 4.0f; // a mouse that moved less has not been dragged

double diagonalOf(const Bounds& bounds)
{
    const double diagonal = bounds.empty ? 1.0 : glm::length(bounds.max - bounds.min);
    return diagonal > 0.0 ? diagonal : 1.0;
}

} // namespace

void Viewer::pickAt(const vec2& place, bool looksAtIt)
{
    if (state.probes && !looksAtIt)
        return probeAt(place);
    const std::optional<Picked> picked =
        pick(*state.scene, shownCamera, area.size, place.x - float(area.first.x), place.y - float(area.first.y));
    if (looksAtIt) {
        if (picked)
            lookAt(freeCamera(), picked->position);
        return;
    }
    state.selectedInstance = picked ? picked->instance : -1;
    if (!picked)
        return;
    const Scene& scene = state.scene->scene();
    if (picked->instance >= 0) {
        const Instance& instance = scene.instances[static_cast<std::size_t>(picked->instance)];
        state.selectedMaterial = scene.primitives[static_cast<std::size_t>(instance.primitive)].material;
    } else
        state.selectedMaterial = scene.shapes[static_cast<std::size_t>(picked->shape)].material;
}

void Viewer::rotateEnvironment(double degrees)
{
    Edits edits = state.edits();
    double& rotation = edits.environment.rotation;
    rotation += degrees;
    rotation -= 360.0 * std::floor((rotation + 180.0) / 360.0);
    state.history->preview(std::move(edits));
    state.changed = true;
}

int Viewer::lampAt(const vec2& place) const
{
    const std::vector<Light>& lights = state.edits().lights;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].kind != Light::Kind::directional)
            if (const auto pixel = pixelOfPoint(lights[i].position, shownCamera, area.size))
                if (glm::length(*pixel + dvec2(area.first) - dvec2(place)) <= kLampRadius)
                    return static_cast<int>(i);
    return -1;
}

// As far as the time since the picture before asks for: a preview, which ends as one step of undo.
void Viewer::turnLamps()
{
    if (!state.scene || state.edits().lights.empty() || !state.lampsTurn) {
        lampsTurnedAt.reset();
        state.lampsTurn = false;
        return;
    }
    const auto now = std::chrono::steady_clock::now();
    const double seconds = lampsTurnedAt ? std::chrono::duration<double>(now - *lampsTurnedAt).count() : 0.0;
    lampsTurnedAt = now;
    const Bounds& bounds = state.scene->bounds;
    Edits edits = state.edits();
    turnLights(edits.lights, bounds.empty ? dvec3(0.0) : 0.5 * (bounds.min + bounds.max),
               state.kept.lampSpeed * std::min(seconds, kLongestTurn));
    state.history->preview(std::move(edits));
    state.changed = true;
}

void Viewer::moveLamp(const vec2& pixels)
{
    Edits edits = state.edits();
    dvec3& position = edits.lights[static_cast<std::size_t>(draggedLamp)].position;
    position = movedByPixels(position, dvec2(pixels), shownCamera, area.size);
    state.history->preview(std::move(edits));
    state.changed = true;
}

void Viewer::handleMouse()
{
    const ImGuiIO& io = ImGui::GetIO();
    if (!state.scene)
        return;
    const vec2 scale(io.DisplayFramebufferScale.x, io.DisplayFramebufferScale.y);
    const vec2 place = vec2(io.MousePos.x, io.MousePos.y) * scale;
    if (!io.WantCaptureMouse)
        for (const int button : {0, 1, 2})
            if (ImGui::IsMouseClicked(button)) {
                pressedAt = lastPlace = window.pressPlaces[static_cast<std::size_t>(button)] * scale;
                dragging = true;
                draggedLamp = button == 0 ? lampAt(pressedAt) : -1;
            }
    if (dragging) {
        const vec2 moved = (place - lastPlace) / float(area.size.y);
        const bool farEnough = glm::length(place - pressedAt) > kClickPixels || draggedFar;
        draggedFar |= farEnough;
        const bool left = ImGui::IsMouseDown(0), pans = ImGui::IsMouseDown(1) || ImGui::IsMouseDown(2) || io.KeyCtrl;
        if (farEnough && moved != vec2(0.0f)) {
            lastPlace = place;
            if (left && draggedLamp >= 0)
                moveLamp(moved * float(area.size.y));
            else if (left && io.KeyShift)
                rotateEnvironment(kDegreesAcross * moved.x);
            else if (pans)
                pan(freeCamera(), -moved.x, moved.y);
            else if (left)
                orbit(freeCamera(), -kDegreesAcross * moved.x, -kDegreesAcross * moved.y);
        }
        if (!left && !ImGui::IsMouseDown(1) && !ImGui::IsMouseDown(2)) {
            if (!draggedFar && ImGui::IsMouseReleased(0))
                pickAt(pressedAt, false);
            state.history->commit(state.edits()); // of the environment's rotation, or of a lamp's place
            dragging = draggedFar = false;
            draggedLamp = -1;
        }
    }
    if (io.WantCaptureMouse)
        return;
    if (ImGui::IsMouseDoubleClicked(0))
        pickAt(place, true);
    if (io.MouseWheel != 0.0f || io.MouseWheelH != 0.0f)
        scroll(freeCamera(), {io.MouseWheelH, io.MouseWheel}, io.KeyShift, diagonalOf(state.scene->bounds));
}

void Viewer::handleCameraKey(const KeyPress& press)
{
    const double diagonal = diagonalOf(state.scene->bounds);
    const auto look = [&](double theta, double phi) {
        state.view = FittedView{theta, phi};
        state.moved = true;
    };
    const bool opposite = press.control;
    switch (press.key) {
    case GLFW_KEY_1:
    case GLFW_KEY_KP_1:
        return look(opposite ? -180.0 : 0.0, 90.0);
    case GLFW_KEY_3:
    case GLFW_KEY_KP_3:
        return look(opposite ? -90.0 : 90.0, 90.0);
    case GLFW_KEY_7:
    case GLFW_KEY_KP_7:
        return look(0.0, opposite ? 180.0 : 0.0);
    default:
        break;
    }
    if (press.control)
        return;
    switch (press.key) {
    case GLFW_KEY_F:
        return press.shift ? frameSelection() : frameAll();
    case GLFW_KEY_C:
        return nextFileCamera();
    case GLFW_KEY_LEFT:
        return orbit(freeCamera(), -kTurnStep, 0.0);
    case GLFW_KEY_RIGHT:
        return orbit(freeCamera(), kTurnStep, 0.0);
    case GLFW_KEY_UP:
        return orbit(freeCamera(), 0.0, -kTurnStep);
    case GLFW_KEY_DOWN:
        return orbit(freeCamera(), 0.0, kTurnStep);
    case GLFW_KEY_W:
        return fly(freeCamera(), kFlyStep, 0.0);
    case GLFW_KEY_S:
        return fly(freeCamera(), -kFlyStep, 0.0);
    case GLFW_KEY_D:
        return fly(freeCamera(), 0.0, kFlyStep);
    case GLFW_KEY_A:
        return fly(freeCamera(), 0.0, -kFlyStep);
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
        return dolly(freeCamera(), 1.0 / kDollyStep, diagonal);
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
        return dolly(freeCamera(), kDollyStep, diagonal);
    default:
        return;
    }
}

void Viewer::frameAll()
{
    state.view = wholeSceneFrom(state.view);
    state.moved = true;
}

void Viewer::frameSelection()
{
    if (state.selectedInstance < 0)
        return;
    const Scene& scene = state.scene->scene();
    const Instance& instance = scene.instances[static_cast<std::size_t>(state.selectedInstance)];
    const Primitive& primitive = scene.primitives[static_cast<std::size_t>(instance.primitive)];
    const dvec3 center(instance.worldFromObject * dvec4(0.5 * (primitive.boundsMin + primitive.boundsMax), 1.0));
    const dvec3 half = 0.5 * dvec3(dmat3(instance.worldFromObject) * (primitive.boundsMax - primitive.boundsMin));
    OrbitPose& pose = freeCamera();
    pose.target = center;
    // The ball around its box touches the upper and the lower edge.
    const double radius = glm::length(half) / std::sin(0.5 * pose.verticalFov * kPi / 180.0);
    dolly(pose, radius / pose.radius, diagonalOf(state.scene->bounds));
}

void Viewer::nextFileCamera()
{
    const int count = static_cast<int>(state.scene->scene().cameras.size());
    if (count == 0) {
        state.notice = "the file has no cameras";
        return;
    }
    const auto* file = std::get_if<FileView>(&state.view);
    state.view = FileView{file ? (file->index + 1) % count : 0};
    state.moved = true;
}

// The one in front; false where none is open.
bool Viewer::closeDialog()
{
    if (!state.error.empty())
        state.error.clear();
    else if (state.unsaved)
        state.unsaved.reset();
    else if (browser.isOpen())
        browser.close();
    else if (state.showHelp || state.showPlan)
        state.showHelp = state.showPlan = false;
    else
        return false;
    return true;
}

void Viewer::handleKeys(const std::vector<KeyPress>& presses)
{
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput)
        return; // they are letters of a name
    for (const ImWchar character : io.InputQueueCharacters)
        if (character == '?')
            state.showHelp = !state.showHelp;
    for (const KeyPress& press : presses) {
        if (press.control)
            handleControlKey(press);
        else if (press.key == GLFW_KEY_TAB)
            state.kept.showPanels = !state.kept.showPanels;
        else if (press.key == GLFW_KEY_ESCAPE) {
            if (!closeDialog())
                state.selectedInstance = -1;
        } else if (press.key == GLFW_KEY_R)
            state.requests.push_back(ReloadShaders{});
        else if (press.key == GLFW_KEY_F5 && state.scene)
            state.requests.push_back(OpenScene{state.scene->input, true});
        if (state.scene)
            handleCameraKey(press);
    }
}

void Viewer::handleControlKey(const KeyPress& press)
{
    const PanelContext context = {state, host, browser, thumbnails, panoramas, places, ImGui::GetFontSize()};
    if (press.key == GLFW_KEY_O)
        askForScene(context);
    else if (press.key == GLFW_KEY_Q)
        state.requests.push_back(Quit{});
    if (!state.scene)
        return;
    if (press.key == GLFW_KEY_P)
        askForPicture(context);
    else if (press.key == GLFW_KEY_S)
        askForSave(context);
    else if (press.key == GLFW_KEY_C)
        state.requests.push_back(CopyCommand{});
    else if (press.key == GLFW_KEY_Z) {
        press.shift ? state.history->redo() : state.history->undo();
        state.changed = true;
    }
}

} // namespace torrance
