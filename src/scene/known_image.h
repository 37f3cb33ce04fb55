// A picture that was decoded before: what there is to say of it without its texels.
#pragma once

#include "core/content_hash.h"
#include "scene/texture.h"

#include <functional>
#include <optional>

namespace torrance {

struct KnownImage
{
    int width = 0;
    int height = 0;
    TexelFormat format = TexelFormat::rgba8;

    bool operator==(const KnownImage&) const = default;
};

/// Asked with the hash of a picture's encoded bytes.
using KnownImages = std::function<std::optional<KnownImage>(const ContentHash& encoded)>;

} // namespace torrance
