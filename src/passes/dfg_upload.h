// A table of directional albedos on the device, in the storage of its row.
#pragma once

#include "brdf/dfg.h"
#include "gpu/image.h"

namespace torrance {

/// Reads the table that the build made: an Error (input) where it is missing or damaged.
gpu::DeviceImage uploadDfgTable(const gpu::Device& device, const brdf::DfgStorage& storage);

} // namespace torrance
