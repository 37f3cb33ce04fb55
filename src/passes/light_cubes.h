// The cubes that light a scene, out of the cache where it has them.
#pragma once

#include "core/disk_cache.h"
#include "prepare/environment_maps.h"

namespace torrance {

/// makeEnvironmentMaps(radiance), kept in `cache` under the panorama's content and the way of making them.
EnvironmentMaps cachedEnvironmentMaps(const Image& radiance, const ContentHash& content, DiskCache& cache);
/// The same of makePhongMaps(radiance).
EnvironmentMaps cachedPhongMaps(const Image& radiance, const ContentHash& content, DiskCache& cache);

} // namespace torrance
