// A picture from a file, whatever its format: what `compare` looks at and what environments are made from.
#pragma once

#include "image/image.h"

#include <string>
#include <vector>

namespace torrance {

struct ReadImage
{
    Image image;
    bool displayReferred = false;          // values are sRGB codes in [0, 1], as PNG, JPEG and WebP hold them
    std::vector<std::string> channelNames; // one per channel: R G B A first, then what else there is, by name
};

/// Told by content: PNG, JPEG, WebP (straight alpha), HDR, EXR (alpha as stored, premultiplied as a rule; the first
/// part); anything else is tried through OpenImageIO. An Error (input) where the file is missing, truncated, corrupt or
/// too large.
ReadImage readImage(const std::string& path);

/// The colour of a picture: its R, G and B, or its only channel three times. An Error (input) where it has neither.
Image colorOf(ReadImage picture, const std::string& path);

} // namespace torrance
