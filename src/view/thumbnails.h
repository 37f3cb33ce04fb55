// Small pictures of a scene's textures, for panels; made when they are first shown.
#pragma once

#include "gpu/image.h"
#include "scene/scene.h"

#include <map>
#include <memory>

namespace torrance {

class Thumbnails
{
public:
    explicit Thumbnails(const gpu::Device& d) : device(d) {}

    /// Of Scene::images; null where the image has no texels.
    const gpu::DeviceImage* get(const Scene& scene, int image);

    /// When another scene is shown. What was got before must have been drawn.
    void clear() { pictures.clear(); }

private:
    const gpu::Device& device;
    std::map<int, gpu::DeviceImage> pictures;
};

} // namespace torrance
