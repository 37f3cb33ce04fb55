#include "view/edits.h"

#include "files/material_difference.h"

#include <algorithm>
#include <utility>

namespace torrance {
namespace {

bool readsOnly(const std::vector<Material>& materials, std::size_t textures)
{
    for (const Material& material : materials)
        for (const auto& [name, role] : kTextureUses)
            if ((material.*role).used() && static_cast<std::size_t>((material.*role).texture) >= textures)
                return false;
    return true;
}

} // namespace

Edits editsOf(const Scene& scene, const EnvironmentChoice& environment)
{
    Edits edits = {.materials = scene.materials,
                   .duplicateOf = {},
                   .primitiveMaterials = {},
                   .lights = scene.lights,
                   .environment = environment};
    for (const Primitive& primitive : scene.primitives)
        edits.primitiveMaterials.push_back(primitive.material);
    return edits;
}

void applyEdits(const Edits& edits, Scene& scene)
{
    scene.materials = edits.materials;
    scene.lights = edits.lights;
    for (std::size_t i = 0; i < scene.primitives.size(); ++i)
        scene.primitives[i].material = edits.primitiveMaterials[i];
    if (scene.environment) {
        scene.environment->rotation = edits.environment.rotation * kPi / 180.0;
        scene.environment->intensity = edits.environment.intensity;
    }
}

Material withTexturesOf(const Material& textures, const Material& factors)
{
    Material result = factors;
    for (const auto& [name, role] : kTextureUses)
        result.*role = textures.*role;
    result.normalScale = textures.normalScale;
    result.occlusionStrength = textures.occlusionStrength;
    return result;
}

void EditHistory::commit(Edits edits)
{
    previewed.reset();
    if (edits == present)
        return;
    past.push_back(std::move(present));
    if (past.size() > kMostUndoSteps)
        past.pop_front();
    future.clear();
    present = std::move(edits);
}

bool EditHistory::goOnWith(const Edits& readAgain, std::size_t textures)
{
    const auto means = [&](const Edits& state) {
        return state.materials.size() == readAgain.materials.size() &&
               state.primitiveMaterials.size() == readAgain.primitiveMaterials.size() &&
               readsOnly(state.materials, textures);
    };
    if (present.materials != readAgain.materials || present.primitiveMaterials != readAgain.primitiveMaterials ||
        !std::ranges::all_of(past, means) || !std::ranges::all_of(future, means))
        return false;
    for (std::deque<Edits>* states : {&past, &future})
        for (Edits& state : *states)
            state.duplicateOf.clear(); // they are the file's own now
    previewed.reset();
    present.duplicateOf.clear();
    saved = present;
    asLoaded = readAgain;
    return true;
}

// The last of `from` becomes the present state, and that the last of `to`.
void EditHistory::step(std::deque<Edits>& from, std::deque<Edits>& to)
{
    previewed.reset();
    if (from.empty())
        return;
    to.push_back(std::exchange(present, std::move(from.back())));
    from.pop_back();
}

bool EditHistory::isDirty() const
{
    return present.materials != saved.materials || present.primitiveMaterials != saved.primitiveMaterials;
}

} // namespace torrance
