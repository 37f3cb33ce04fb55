// What is changed of a scene in the window, as plain data: what undo goes back to, and what is saved.
#pragma once

#include "brdf/method.h"
#include "plan/settings.h"
#include "scene/scene.h"

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace torrance {

/// The light around a scene as it was chosen: a name or a file, "none" for none.
struct EnvironmentChoice
{
    std::string name = "studio";
    double rotation = 0.0; // degrees about +Y
    double intensity = 1.0;

    bool operator==(const EnvironmentChoice&) const = default;
};

struct Edits
{
    std::vector<Material> materials;     // Scene::materials
    std::vector<int> duplicateOf;        // by the materials that were added: which each began as
    std::vector<int> primitiveMaterials; // Primitive::material, by Scene::primitives
    std::vector<Light> lights;
    EnvironmentChoice environment;

    bool operator==(const Edits&) const = default;
};

Edits editsOf(const Scene& scene, const EnvironmentChoice& environment);

/// Puts materials, their places and the lights into the scene; the environment's rotation and intensity where it has
/// one.
void applyEdits(const Edits& edits, Scene& scene);

/// The factors, modes and name of `factors` with the textures of `textures`, and what belongs to these.
Material withTexturesOf(const Material& textures, const Material& factors);

/// The states before the present one, and those that were gone back from.
class EditHistory
{
public:
    /// Of a scene that was just loaded.
    explicit EditHistory(Edits now) : present(now), saved(std::move(now)), asLoaded(saved) {}

    const Edits& now() const { return present; }

    /// Changes the present state for a while: a slider is being dragged.
    void preview(Edits edits) { previewed = std::move(edits); }
    const Edits& shown() const { return previewed ? *previewed : present; }

    /// One step that undo takes back; nothing where nothing was changed.
    void commit(Edits edits);

    bool canUndo() const { return !past.empty(); }
    bool canRedo() const { return !future.empty(); }
    void undo() { step(past, future); }
    void redo() { step(future, past); }

    /// Materials or their places differ from what was loaded or saved last.
    bool isDirty() const;
    void markSaved(Edits edits) { saved = std::move(edits); }
    /// The scene was read again, from a file that holds what is shown now: the states before stay, where they mean the
    /// same in it. False, and nothing is changed, where they do not: it has other materials, or one of the states has
    /// more or fewer, or textures that are not there (`textures`: how many are).
    bool goOnWith(const Edits& readAgain, std::size_t textures);
    /// As they were read.
    const Edits& loaded() const { return asLoaded; }

private:
    void step(std::deque<Edits>& from, std::deque<Edits>& to);
    std::deque<Edits> past, future;
    std::optional<Edits> previewed;
    Edits present;
    Edits saved;
    Edits asLoaded;
};

inline constexpr std::size_t kMostUndoSteps = 200; // some MB for a scene of thousands of materials

} // namespace torrance
