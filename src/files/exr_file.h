// OpenEXR pictures: any number of named channels of float.
#pragma once

#include "image/image.h"

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace torrance {

/// Channels that belong together. In the file a channel is called `<layer>.<channel>`, or `<channel>` in the layer "".
struct ImageLayer
{
    std::string name;
    std::vector<std::string> channels; // R G B A, X Y Z, ...: one per channel of the image
    Image image;
};

struct ExrImage
{
    Image image;                           // the display window; 0 where the data window does not reach
    std::vector<std::string> channelNames; // one per channel of the image, sorted by name
    int parts = 1;                         // of which the first is read
};

bool isExr(std::span<const std::byte> bytes);

/// All channels of the first part, half, float and unsigned ones alike, as float. An Error (input) where the file is
/// truncated or corrupt, deep, has subsampled channels or is larger than the limits of image_limits.h.
ExrImage decodeExr(std::span<const std::byte> bytes, const std::string& file);

/// A string attribute of the first part's header; nothing where it has none of this name. An Error (input) where the
/// header is corrupt.
std::optional<std::string> exrAttribute(std::span<const std::byte> bytes, const std::string& file,
                                        const std::string& name);

/// 32-bit float, ZIP. All layers have the size of the first. `attributes` become string attributes of the header.
std::vector<std::byte> encodeExr(std::span<const ImageLayer> layers,
                                 const std::map<std::string, std::string>& attributes);

} // namespace torrance
