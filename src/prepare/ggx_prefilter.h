// Radiance averaged by the GGX lobe of a rough surface seen head on: the first factor of the split sum (Karis 2013).
#pragma once

#include "prepare/cube_levels.h"
#include "prepare/cube_tree.h"

namespace torrance {

/// Integral over the sphere of the kernel of N = V = R, D(h) NoL up to a factor: with h at half the angle theta of l
/// from n, q = sin^2(theta / 2), it is (1 - 2 q) / (alpha^2 + (1 - alpha^2) q)^2 above the horizon.
double ggxKernelIntegral(double alpha);

/// One level of 6 faces of `size` (a multiple of kBlockSide), RGBA: the mean of base + excess under the kernel of
/// `alpha`.
std::vector<float> prefilterLevel(const CubeTree& base, const CubeTree& excess, int size, double alpha);

} // namespace torrance
