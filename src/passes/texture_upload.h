// A plan's textures on the device, each once per use of its values.
#pragma once

#include "gpu/image.h"
#include "plan/shading_plan.h"
#include "prepare/mips.h"

#include <map>
#include <vector>

namespace torrance {

/// What the members of a TextureSet hold: it decides their format and how their mips are made.
TexelContent contentOf(std::size_t slot);

class Textures
{
public:
    /// Uploads the textures of all batches. `samples` per pixel sharpen the choice of mips: a sample stands for 1/N of
    /// a pixel.
    Textures(const gpu::Device& device, const Scene& scene, const ShadingPlan& plan);

    const gpu::DeviceImage& image(int texture, TexelContent content) const;
    const vk::raii::Sampler& sampler(int texture) const;
    std::vector<gpu::ImageUse> uses() const; // as sampled

private:
    std::map<std::pair<int, TexelContent>, gpu::DeviceImage> images; // by Scene::images
    std::vector<vk::raii::Sampler> samplers;                         // by Scene::textures; null where unused
    std::vector<int> imageOf;                                        // by Scene::textures
};

} // namespace torrance
