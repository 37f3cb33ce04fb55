// Tables of directional albedos on the device.
#pragma once

#include "brdf/dfg.h"
#include "gpu/image.h"

namespace torrance {

/// In the storage of its row. Reads the table that the build made: an Error (input) where it is missing or damaged.
gpu::DeviceImage uploadDfgTable(const gpu::Device& device, const brdf::DfgStorage& storage);

/// Source B's map, likewise.
gpu::DeviceImage uploadIntegrationMap(const gpu::Device& device);

} // namespace torrance
