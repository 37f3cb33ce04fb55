// The cubes that light a scene, out of the files that keep them where there are such.
#pragma once

#include "gpu/image.h"
#include "prepare/kept_maps.h"

namespace torrance {

struct LightCubes
{
    gpu::DeviceImage specular;
    gpu::DeviceImage diffuse;
};

/// The maps of the method of the slot environment_specular: shipped with the program, or out of the cache, or made and
/// kept there. `content` is the panorama's.
LightCubes makeLightCubes(const gpu::Device& device, const brdf::Method& specular, const Image& radiance,
                          const ContentHash& content, DiskCache& cache);

/// The same in the host's memory.
EnvironmentMaps keptEnvironmentMaps(const brdf::Method& specular, const Image& radiance, const ContentHash& content,
                                    DiskCache& cache);

/// Whether shaders read the fourth channel: the small ones, in the cube of lamps alone.
enum class CubeAlpha
{
    read,
    unread,
};

gpu::DeviceImage uploadCube(const gpu::Device& device, const CubeLevels& cube, CubeAlpha alpha, const char* name);

} // namespace torrance
