#include "plan/material_plan.h"

#include "image/srgb.h"
#include "scene/phong.h"

#include <algorithm>
#include <optional>

namespace torrance {
namespace {

class Reducer
{
public:
    Reducer(const Scene& s, std::span<const TexelFacts> f, const std::string& name, Remarks& r)
        : scene(s), facts(f), subject(name), remarks(r)
    {
    }

    /// The facts of a texture, or nothing where there is no texture.
    std::optional<TexelFacts> of(const TextureUse& use) const
    {
        if (!use.used())
            return std::nullopt;
        return facts[static_cast<std::size_t>(scene.textures[static_cast<std::size_t>(use.texture)].image)];
    }

    void drop(TextureUse& use, const char* what, const char* reason)
    {
        use = {};
        remarks.push_back({subject, std::string("no ") + what, reason});
    }

    void note(const char* choice, const char* reason) { remarks.push_back({subject, choice, reason}); }

private:
    const Scene& scene;
    std::span<const TexelFacts> facts;
    const std::string& subject;
    Remarks& remarks;
};

void reduceBaseColor(Material& m, MaterialRange& range, Reducer& reducer)
{
    const auto facts = reducer.of(m.baseColor);
    if (!facts) {
        range.greatestBaseColor = dvec3(m.baseColorFactor);
        return;
    }
    for (int c = 0; c < 3; ++c)
        range.greatestBaseColor[c] = m.baseColorFactor[c] * srgbDecode(facts->greatest[static_cast<std::size_t>(c)]);
    const double leastAlpha = m.baseColorFactor.a * facts->least[3];
    if (m.alphaMode == AlphaMode::mask && leastAlpha >= m.alphaCutoff) {
        m.alphaMode = AlphaMode::opaque;
        reducer.note("drawn opaque", "no texel lies below the alpha cutoff");
    }
    if (m.alphaMode == AlphaMode::blend && leastAlpha >= 1.0) {
        m.alphaMode = AlphaMode::opaque;
        reducer.note("drawn opaque", "every alpha is 1");
    }
    const bool alphaMatters = m.alphaMode != AlphaMode::opaque;
    if (facts->constant(0) && facts->constant(1) && facts->constant(2) && (facts->constant(3) || !alphaMatters)) {
        for (int c = 0; c < 3; ++c)
            m.baseColorFactor[c] *= srgbDecode(facts->least[static_cast<std::size_t>(c)]);
        m.baseColorFactor.a *= facts->least[3];
        reducer.drop(m.baseColor, "base colour texture", "all its texels are alike: they became the factor");
    }
}

// A scalar that does not vary becomes the factor.
bool reduceScalar(double& factor, const TexelFacts& facts, int channel, Reducer& reducer, const char* choice)
{
    if (factor != 0.0 && !facts.constant(channel))
        return true;
    factor *= facts.least[static_cast<std::size_t>(channel)];
    reducer.note(choice, "all its texels are alike: they became the factor");
    return false;
}

void reduceMetallicRoughness(PlannedMaterial& planned, Reducer& reducer)
{
    Material& m = planned.material;
    MaterialRange& range = planned.range;
    const auto facts = reducer.of(m.metallicRoughness);
    constexpr std::size_t kRoughness = 1, kMetallic = 2;
    const double leastG = facts ? facts->least[kRoughness] : 1, greatestG = facts ? facts->greatest[kRoughness] : 1;
    const double greatestB = facts ? facts->greatest[kMetallic] : 1;
    range.leastRoughness = m.roughnessFactor * leastG;
    range.greatestRoughness = m.roughnessFactor * greatestG;
    range.greatestMetallic = m.metallicFactor * greatestB;
    if (!facts)
        return;
    planned.roughnessVaries = reduceScalar(m.roughnessFactor, *facts, kRoughness, reducer, "no roughness texture");
    planned.metallicVaries = reduceScalar(m.metallicFactor, *facts, kMetallic, reducer, "no metallic texture");
    if (!planned.roughnessVaries && !planned.metallicVaries)
        m.metallicRoughness = {};
}

// The encoding of a flat normal: 8-bit zero is written as 127 or 128, 16-bit zero as 32767 or 32768.
bool encodesFlat(const TexelFacts& facts)
{
    constexpr double kHalfStep = 0.5 / 255.0 + 1e-9; // distance of 127/255 and 128/255 from one half
    for (std::size_t c = 0; c < 2; ++c)
        if (facts.least[c] < 0.5 - kHalfStep || facts.greatest[c] > 0.5 + kHalfStep)
            return false;
    return facts.least[2] > 0.5;
}

void reduceNormal(Material& m, Reducer& reducer)
{
    const auto facts = reducer.of(m.normal);
    if (!facts)
        return;
    if (m.normalScale == 0.0)
        reducer.drop(m.normal, "normal map", "its scale is 0");
    else if (encodesFlat(*facts))
        reducer.drop(m.normal, "normal map", "it is flat");
}

void reduceOcclusion(Material& m, Reducer& reducer)
{
    const auto facts = reducer.of(m.occlusion);
    if (!facts)
        return;
    if (m.occlusionStrength == 0.0)
        reducer.drop(m.occlusion, "occlusion texture", "its strength is 0");
    else if (facts->least[0] == 1.0)
        reducer.drop(m.occlusion, "occlusion texture", "all its texels are 1");
}

void reduceEmissive(Material& m, Reducer& reducer)
{
    const auto facts = reducer.of(m.emissive);
    if (!facts)
        return;
    if (m.emissiveFactor == dvec3(0.0))
        return reducer.drop(m.emissive, "emissive texture", "its factor is 0");
    if (std::max({facts->greatest[0], facts->greatest[1], facts->greatest[2]}) == 0.0) {
        m.emissiveFactor = dvec3(0.0);
        return reducer.drop(m.emissive, "emissive texture", "it is black");
    }
    if (facts->constant(0) && facts->constant(1) && facts->constant(2)) {
        for (int c = 0; c < 3; ++c)
            m.emissiveFactor[c] *= srgbDecode(facts->least[static_cast<std::size_t>(c)]);
        reducer.drop(m.emissive, "emissive texture", "all its texels are alike: they became the factor");
    }
}

// Unlit surfaces are base colour alone: nothing else of the material is looked at.
void reduceUnlit(Material& m, Reducer& reducer)
{
    for (TextureUse* use : {&m.metallicRoughness, &m.normal, &m.occlusion, &m.emissive})
        if (use->used())
            reducer.drop(*use, "texture but base colour", "the material is unlit");
    m.emissiveFactor = dvec3(0.0);
}

} // namespace

PlannedMaterial planMaterial(const Scene& scene, const Material& material, std::span<const TexelFacts> facts,
                             const std::string& subject, Remarks& remarks)
{
    PlannedMaterial planned = {.material = material, .range = {}};
    Material& m = planned.material;
    Reducer reducer(scene, facts, subject, remarks);
    if (m.alphaMode == AlphaMode::blend && !m.baseColor.used() && m.baseColorFactor.a >= 1.0) {
        m.alphaMode = AlphaMode::opaque;
        reducer.note("drawn opaque", "its alpha is 1");
    }
    reduceBaseColor(m, planned.range, reducer);
    if (m.unlit) {
        reduceUnlit(m, reducer);
        return planned;
    }
    reduceMetallicRoughness(planned, reducer);
    planned.range.dielectricF0 = reflectanceOfIor(m.ior);
    reduceNormal(m, reducer);
    reduceOcclusion(m, reducer);
    reduceEmissive(m, reducer);
    return planned;
}

} // namespace torrance
