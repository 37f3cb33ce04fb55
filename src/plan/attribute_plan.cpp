#include "plan/attribute_plan.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace torrance {
namespace {

constexpr std::size_t kMaxClasses = 255; // numbers of a stencil buffer but for 0, which is nothing

// One place and one level of detail for all textures of a batch's material.
bool sampledAlike(const ShadingPlan& plan, const Material& material, const TextureSet& textures)
{
    if (std::ranges::all_of(textures, [](int texture) { return texture < 0; }))
        return true;
    if (!sharedPlace(material, textures))
        return false;
    const PlannedTexture* first = nullptr;
    for (const int texture : textures) {
        if (texture < 0)
            continue;
        const PlannedTexture& own = plan.textures[static_cast<std::size_t>(texture)];
        if (first && own.width * first->height != own.height * first->width)
            return false;
        first = &own;
    }
    return true;
}

// The blocks of a batch's draws, each once.
std::vector<int> blocksOf(const Batch& batch)
{
    std::vector<int> blocks;
    for (const Draw& draw : batch.draws)
        blocks.push_back(draw.block);
    std::ranges::sort(blocks);
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    return blocks;
}

class ClassPlanner
{
public:
    explicit ClassPlanner(ShadingPlan& p) : plan(p) {}

    void run()
    {
        std::vector<Batch> batches;
        for (Batch& batch : plan.batches)
            if (leavesAttributes(plan, batch))
                std::ranges::move(parts(std::move(batch)), std::back_inserter(batches));
            else
                batches.push_back(std::move(batch));
        plan.batches = std::move(batches);
        for (Batch& batch : plan.batches)
            if (leavesAttributes(plan, batch))
                assign(batch);
    }

private:
    // A batch as batches of as many materials as a class can have.
    static std::vector<Batch> parts(Batch batch)
    {
        const std::vector<int> blocks = blocksOf(batch);
        std::vector<Batch> result((blocks.size() - 1) / kMaxClassMaterials + 1);
        for (Batch& part : result)
            part = {.key = batch.key, .textures = batch.textures, .draws = {}};
        for (const Draw& draw : batch.draws) {
            const auto place = std::ranges::lower_bound(blocks, draw.block) - blocks.begin();
            result[static_cast<std::size_t>(place) / kMaxClassMaterials].draws.push_back(draw);
        }
        return result;
    }

    // A batch belongs to one class whole: it is drawn under one number of the stencil.
    void assign(Batch& batch)
    {
        const std::vector<int> blocks = blocksOf(batch);
        const auto index = classFor(resolveKey(batch.key), batch.textures, blocks);
        if (!index)
            return;
        batch.shadingClass = *index;
        ShadingClass& shadingClass = plan.classes[static_cast<std::size_t>(*index)];
        for (Draw& draw : batch.draws)
            draw.block = blockIn(shadingClass, draw.block);
    }

    std::optional<int> classFor(const ShaderKey& key, const TextureSet& textures, const std::vector<int>& blocks)
    {
        for (std::size_t i = 0; i < plan.classes.size(); ++i) {
            const ShadingClass& c = plan.classes[i];
            if (c.key == key && c.textures == textures && c.blocks.size() + blocks.size() <= kMaxClassMaterials)
                return static_cast<int>(i);
        }
        if (plan.classes.size() == kMaxClasses)
            return std::nullopt;
        plan.classes.push_back({key, textures, {}});
        return static_cast<int>(plan.classes.size() - 1);
    }

    int blockIn(ShadingClass& shadingClass, int block)
    {
        const int material = plan.blocks[static_cast<std::size_t>(block)].material;
        for (const int known : shadingClass.blocks)
            if (plan.blocks[static_cast<std::size_t>(known)].material == material)
                return known;
        MaterialBlock own = plan.blocks[static_cast<std::size_t>(block)];
        own.slot = static_cast<int>(shadingClass.blocks.size());
        plan.blocks.push_back(own);
        shadingClass.blocks.push_back(static_cast<int>(plan.blocks.size() - 1));
        return shadingClass.blocks.back();
    }

    ShadingPlan& plan;
};

} // namespace

bool leavesAttributes(const ShadingPlan& plan, const Batch& batch)
{
    const ShaderKey& key = batch.key;
    if (key.surface != SurfaceKind::triangles || !key.normals || key.colors)
        return false;
    return std::ranges::all_of(batch.draws, [&](const Draw& draw) {
        const int material = plan.blocks[static_cast<std::size_t>(draw.block)].material;
        return sampledAlike(plan, plan.materials[static_cast<std::size_t>(material)].material, batch.textures);
    });
}

void planAttributes(ShadingPlan& plan)
{
    ClassPlanner(plan).run();
}

ShaderKey resolveKey(const ShaderKey& key)
{
    ShaderKey rest = key;
    rest.alphaMode = AlphaMode::opaque;
    rest.doubleSided = false;      // the attributes tell which side is seen
    rest.vanishingNormals = false; // and hold another where there is none
    for (TextureKey* texture :
         {&rest.baseColor, &rest.material, &rest.normal, &rest.occlusion, &rest.emissive, &rest.words})
        *texture = {.used = texture->used};
    return rest;
}

std::size_t attributePictures(const ShadingPlan& plan)
{
    return std::ranges::any_of(plan.classes, [](const ShadingClass& c) { return c.key.usesUv(0); }) ? 2 : 1;
}

std::optional<TextureRole> levelRole(const ShadingPlan& plan, const TextureSet& textures)
{
    std::optional<TextureRole> largest;
    int width = 0;
    for (std::size_t role = 0; role < kTextureRoles; ++role) {
        if (textures[role] < 0)
            continue;
        const int own = plan.textures[static_cast<std::size_t>(textures[role])].width;
        if (own > width)
            largest = static_cast<TextureRole>(role);
        width = std::max(width, own);
    }
    return largest;
}

} // namespace torrance
