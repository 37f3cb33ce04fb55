// What is asked of a reference picture.
#pragma once

#include "brdf/method.h"
#include "math/replicates.h"
#include "reference/light_integral.h"

#include <optional>

namespace torrance {

/// Directions come in whole turns of every replicate.
inline constexpr int kDirectionsPerRound = kReplicates * static_cast<int>(kDirectionsPerTurn);

struct ReferenceSettings
{
    brdf::Preset methods;
    bool physics = false;   // the yardstick: physics instead of the methods
    bool transport = false; // shadows and interreflection: `directions` are paths of each visible surface
    int width = 1024;
    int height = 1024;
    int pixelSamples = 1;                           // places in the pixel, by the reconstruction filter
    int directions = 256;                           // per surface point and light that is no point: a multiple of
                                                    // kDirectionsPerRound
    std::optional<double> targetError;              // adaptive: directions double until a pixel's error is below
    int maxDirections = 1 << 16;                    // where they stop doubling
    std::optional<dvec4> background = std::nullopt; // premultiplied; none: the environment
    DirectionChoice choice = DirectionChoice::combined;
    std::uint64_t seed = 0; // pictures of different seeds are independent: their difference is their noise
    /// Textures are filtered as a picture of one look at each place is: by level, with this bias (reference/
    /// texture_levels.h). None: level 0, whatever lies under the pixel.
    std::optional<double> levelBias = std::nullopt;
};

} // namespace torrance
