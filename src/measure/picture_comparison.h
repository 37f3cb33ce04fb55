// All that `compare` says of two pictures.
#pragma once

#include "measure/image_metrics.h"

namespace torrance {

/// A picture made fit to be compared.
struct ComparedPicture
{
    Image linear;                 // 3 channels, display-linear or scene-linear, over black
    Image alpha;                  // 1 channel; empty where the picture has none
    bool displayReferred = false; // chooses LDR-FLIP over HDR-FLIP
};

struct PictureComparison
{
    ImageMetrics metrics; // of the linear colour
    double meanFlip = 0.0;
    double flip99 = 0.0;             // 99th percentile
    double maxAlphaDifference = 0.0; // a missing alpha counts as 1
    Image flipMap;                   // one channel
};

/// Both pictures have one size and are both display-referred or both not. For FLIP, which knows no NaN and Inf, these
/// count as black; the metrics leave such pixels out and count them.
PictureComparison comparePictures(const ComparedPicture& reference, const ComparedPicture& test);

} // namespace torrance
