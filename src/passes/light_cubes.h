// The cubes that light a scene, out of the cache where it has them.
#pragma once

#include "brdf/method.h"
#include "core/disk_cache.h"
#include "prepare/environment_maps.h"

namespace torrance {

/// The maps that the method of the slot environment_specular looks up, kept in `cache` under the panorama's content and
/// the way of making them.
EnvironmentMaps cachedEnvironmentMaps(const brdf::Method& specular, const Image& radiance, const ContentHash& content,
                                      DiskCache& cache);

} // namespace torrance
