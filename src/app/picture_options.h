// How large a picture is and what stands behind its surfaces, by options that several commands share.
#pragma once

#include "math/vector.h"
#include "plan/settings.h"

#include <string>

namespace CLI {
class App;
}

namespace torrance {

struct PictureOptions
{
    std::string resolution = "1024x1024";
    std::string background = "environment";
    bool noBackground = false;
};

struct Background
{
    BackgroundKind kind = BackgroundKind::environment;
    dvec3 color = dvec3(0.0); // scene-linear; of BackgroundKind::color
};

void declarePictureOptions(CLI::App& app, PictureOptions& options);

/// Width and height; an Error (usage) where the text is no size or a side is larger than what is drawn.
ivec2 chosenSize(const PictureOptions& options);

/// An Error (usage) where the text is no background or two exclude each other.
Background chosenBackground(const PictureOptions& options);

/// An Error (usage) where a picture needs more than this machine's memory, before it brings the machine down.
void checkMemory(const PictureOptions& options, double bytesPerPixel);

} // namespace torrance
