// Changes of one panel in one picture of the window: a preview while something is dragged, a step of undo when it is
// let go.
#pragma once

#include "view/viewer_state.h"

#include <imgui.h>

namespace torrance {

class EditScope
{
public:
    explicit EditScope(ViewerState& s) : edits(s.edits()), state(s) {}
    ~EditScope()
    {
        if (done)
            state.history->commit(std::move(edits));
        else if (changed)
            state.history->preview(std::move(edits));
        state.changed |= changed || done;
    }
    EditScope(const EditScope&) = delete;
    EditScope& operator=(const EditScope&) = delete;

    /// After an item that returned whether it changed its value.
    void after(bool itemChanged)
    {
        changed |= itemChanged;
        done |= ImGui::IsItemDeactivatedAfterEdit();
    }
    /// Something that is done at once.
    void finish() { done = true; }

    Edits edits;

private:
    ViewerState& state;
    bool changed = false;
    bool done = false;
};

} // namespace torrance
