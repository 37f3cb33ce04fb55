// Small pictures of environments, for panels: read beside everything else, one after the other.
#pragma once

#include "gpu/image.h"
#include "scene/scene.h"
#include "view/background_task.h"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace torrance {

/// Codes of red, green, blue and alpha, `width` to a row: means of the radiance under each pixel, exposed so that their
/// median is a middle grey. Width twice the height.
std::vector<std::uint8_t> panoramaCodes(const Image& radiance, int width);

class PanoramaThumbnails
{
public:
    /// Throws Error; called from another thread.
    using Load = std::function<std::optional<Environment>(const std::string& name)>;

    PanoramaThumbnails(const gpu::Device& d, Load loadByName, void (*announceEnd)())
        : device(d), load(std::move(loadByName)), task(announceEnd)
    {
    }

    /// Null until it was made: it is asked for by this. Of what has no picture (no light, a damaged file) it stays so.
    const gpu::DeviceImage* get(const std::string& name);

    /// Takes what has been made, and begins with what was asked for next. Once for each picture of the window.
    void step();

private:
    const gpu::Device& device;
    Load load;
    std::vector<std::string> asked; // and not begun
    std::set<std::string> known;    // asked for at any time
    std::string begun;
    BackgroundTask<std::vector<std::uint8_t>> task;
    std::map<std::string, gpu::DeviceImage> pictures;
};

} // namespace torrance
