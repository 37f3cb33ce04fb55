// Smaller forms of the table of directional albedos.
#pragma once

#include "brdf/dfg.h"
#include "prepare/dfg_table.h"

#include <cstddef>
#include <vector>

namespace torrance {

/// The table at other nodes, looked up in it; the same table where the size is its own. Sides of at least 2.
DfgTable dfgWithNodes(const DfgTable& table, int width, int height);

/// Texels as the device stores them: floats, halves (each within 2^-11 of its value), or multiples of 1/65535 from 0
/// to 1. The table leaves that range at nodes of NoV < 1e-3 only, which stand off the exact value for the sake of what
/// is interpolated; they are clipped.
std::vector<std::byte> packDfg(const DfgTable& table, brdf::DfgFormat format);

} // namespace torrance
