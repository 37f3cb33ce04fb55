// A pixel's colour from what its samples know: the rows of slot pixelSampling.
#pragma once

#include "math/vector.h"

#include <array>
#include <functional>
#include <vector>

namespace torrance::brdf {

/// What stands in and around a pixel. Depths are reversed: greater is nearer, and 0 means that nothing is there. They
/// are linear over a plane's pixels, as those of a depth buffer are.
struct PixelQuery
{
    std::vector<dvec4> sampleColors = {};    // each sample shaded, premultiplied
    std::array<double, 4> sampleDepths = {}; // at kSamplePlaces
    std::array<double, 49> depths = {};      // at the centres of 7 x 7 pixels, row after row; 24: this one
    std::array<dvec4, 9> colors = {};        // shaded at the centres of 3 x 3 pixels; 4: this one
    std::function<double(double depth)> widthInDepth = nullptr; // what depth loses over a pixel's width behind it
};

/// Vulkan's standard places of four samples (specification, table of standard sample locations), in pixels from the
/// centre, x right and y down.
inline constexpr std::array<dvec2, 4> kSamplePlaces = {dvec2(-0.125, -0.375), dvec2(0.375, -0.125),
                                                       dvec2(-0.375, 0.125), dvec2(0.125, 0.375)};

/// shaders/shared/constants.h has it for the device.
inline constexpr double kPixelFlatness = 0.1;

/// The mean of sampleColors.
dvec4 PS_supersampled(const PixelQuery& query);
/// From one shading a pixel: where the samples' depths are not those of one plane, each takes the colour of the pixel
/// nearby whose surface it lies on.
dvec4 PS_reconstructed(const PixelQuery& query);

} // namespace torrance::brdf
