// Samplers: glTF's, and the two that the passes themselves need.
#pragma once

#include "gpu/device.h"
#include "scene/texture.h"

namespace torrance {

/// `lodBias` is added to the level that the derivatives give.
vk::raii::Sampler makeSampler(const gpu::Device& device, const Sampler& sampler, float lodBias);

/// Trilinear, clamped: environments and tables.
vk::raii::Sampler makeTableSampler(const gpu::Device& device);

/// Of pictures that are read texel by texel: of numbers, which have no filter.
vk::raii::Sampler makePointSampler(const gpu::Device& device);

/// Trilinear, repeated along u and clamped along v: lat-long panoramas.
vk::raii::Sampler makePanoramaSampler(const gpu::Device& device);

} // namespace torrance
