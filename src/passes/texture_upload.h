// A plan's textures on the device.
#pragma once

#include "gpu/image.h"
#include "plan/shading_plan.h"

#include <functional>
#include <map>
#include <span>
#include <vector>

namespace torrance {

/// Called with an index of Scene::images when the texels of that image have been read for the last time; of one that no
/// texture reads, too.
using TexelsRead = std::function<void(int image)>;

class Textures
{
public:
    /// Uploads ShadingPlan::textures, each from the level of this number on (level_plan.h). Several samples per pixel
    /// sharpen the choice of mips: one stands for 1/N of a pixel.
    Textures(const gpu::Device& device, const Scene& scene, const ShadingPlan& plan, std::span<const int> finestLevels,
             const TexelsRead& texelsRead = {});

    // By ShadingPlan::textures.
    const gpu::DeviceImage& image(int texture) const;
    const vk::raii::Sampler& sampler(int texture) const;
    std::vector<gpu::ImageUse> uses() const; // as sampled

private:
    std::vector<gpu::DeviceImage> images;
    std::map<Sampler, vk::raii::Sampler> samplers;
    std::vector<Sampler> samplerOf;
};

/// Whether two plans of one scene have the same textures, each whole.
bool makesSameTextures(const ShadingPlan& a, const ShadingPlan& b);

} // namespace torrance
