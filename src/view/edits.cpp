#include "view/edits.h"

#include <utility>

namespace torrance {

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
    for (const auto role : {&Material::baseColor, &Material::metallicRoughness, &Material::normal, &Material::occlusion,
                            &Material::emissive})
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
