// A plan's textures on the device.
#pragma once

#include "gpu/image.h"
#include "plan/shading_plan.h"
#include "prepare/kept_textures.h"

#include <exception>
#include <functional>
#include <future>
#include <map>
#include <span>
#include <vector>

namespace torrance {

/// Called with an index of Scene::images when the texels of that image have been read for the last time; of one that no
/// texture reads, too.
using TexelsRead = std::function<void(int image)>;

/// Levels that were made before, and a place for those that are made, which outlives the textures.
struct KeptLevels
{
    KeptTextures* textures = nullptr;          // null: every level is made, none is kept
    std::span<const ContentHash> encoded = {}; // as of levelsKey()
};

/// Levels are not kept, and the pictures that they are made from have no texels: the scene has to be read with them.
struct TexelsMissing : std::exception
{
    const char* what() const noexcept override { return "levels of a texture are not kept, and it has no texels"; }
};

class Textures
{
public:
    /// Uploads ShadingPlan::textures, each from the level of this number on (level_plan.h). Several samples per pixel
    /// sharpen the choice of mips: one stands for 1/N of a pixel.
    /// Throws TexelsMissing.
    Textures(const gpu::Device& device, const Scene& scene, const ShadingPlan& plan, std::span<const int> finestLevels,
             const TexelsRead& texelsRead = {}, const KeptLevels& kept = {});

    // By ShadingPlan::textures.
    const gpu::DeviceImage& image(int texture) const;
    const vk::raii::Sampler& sampler(int texture) const;
    std::vector<gpu::ImageUse> uses() const; // as sampled

private:
    std::vector<gpu::DeviceImage> images;
    std::map<Sampler, vk::raii::Sampler> samplers;
    std::vector<Sampler> samplerOf;
    std::future<void> keeping; // reads the images, and ends before they do
};

/// Whether two plans of one scene have the same textures, each whole.
bool makesSameTextures(const ShadingPlan& a, const ShadingPlan& b);

} // namespace torrance
