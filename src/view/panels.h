// The window's panels. Each reads and changes the state; what takes time is asked for there.
#pragma once

#include "view/viewer_state.h"

#include <map>
#include <string>

namespace torrance {

class Thumbnails;
class PanoramaThumbnails;
class FileBrowser;

/// Where things stand in the window, in its coordinates, by name: for the report, which tests and scripts click by.
using Places = std::map<std::string, vec4>; // left, top, right, bottom

/// What panels share while one picture of the window is made.
struct PanelContext
{
    ViewerState& state;
    const ViewerHost& host;
    FileBrowser& browser;
    Thumbnails& thumbnails;
    PanoramaThumbnails& panoramas;
    Places& places;
    float unit; // height of a line of text: panels are laid out in these

    /// Notes where the last item stands.
    void mark(const std::string& name) const;
    /// The same of the whole panel or dialog that is being made.
    void markWindow(const std::string& name) const;
};

/// The menu bar; its height.
float drawMenu(const PanelContext& context);
/// The line at the bottom; its height.
float drawStatus(const PanelContext& context);
/// The column at the right between the two, with one section a panel; its width.
float drawColumn(const PanelContext& context, float top, float bottom);
/// What is open above everything: errors, the file browser, progress, questions, help, the plan.
void drawDialogs(const PanelContext& context);

/// Open the file browser with their question.
void askForScene(const PanelContext& context);
void askForEnvironment(const PanelContext& context);
void askForComparison(const PanelContext& context);
void askForPicture(const PanelContext& context);
void askForSave(const PanelContext& context);
/// The same, and then what was asked for before, which had to wait for it.
void askForSaveBefore(const PanelContext& context, const Request& waiting);
void askForTurntable(const PanelContext& context);

void drawScenePanel(const PanelContext& context);
void drawMaterialPanel(const PanelContext& context);
void drawLightPanel(const PanelContext& context);
void drawMethodPanel(const PanelContext& context); // with the two that follow
void drawTolerancePanel(const PanelContext& context);
void drawErrorPanel(const PanelContext& context);
void drawPicturePanel(const PanelContext& context);

} // namespace torrance
