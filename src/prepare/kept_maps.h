// Prefiltered environments as files keep them: by what they are made from, in the order in which they are uploaded.
#pragma once

#include "brdf/method.h"
#include "core/disk_cache.h"
#include "prepare/environment_maps.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace torrance {

/// The maps that the method of the slot environment_specular looks up.
EnvironmentMaps makeMaps(const brdf::Method& specular, const Image& panorama);

/// A panorama by its texels.
ContentHash panoramaContent(const Image& panorama);

/// What the maps of a panorama are kept under: its content and the way of making them.
ContentHash mapsKey(const brdf::Method& specular, const ContentHash& panorama);

/// The head of kept maps. The texels of the prefiltered cube follow, all faces of level 0, then of level 1 and so on,
/// and those of the irradiance.
struct KeptShape
{
    std::uint32_t size, levels, irradianceSize, zero;
};

/// Maps as parts of a result. They must outlive it.
class KeptForm
{
public:
    explicit KeptForm(const EnvironmentMaps& maps);
    KeptForm(const KeptForm&) = delete;
    KeptForm& operator=(const KeptForm&) = delete;

    std::span<const std::span<const std::byte>> parts() const { return list; }

private:
    KeptShape shape;
    std::vector<std::span<const std::byte>> list;
};

/// The next that is read of kept maps. Nothing where the file is damaged so that it asks for too much memory.
std::optional<KeptShape> readShape(KeptResult& kept);

/// All of them. Nothing where the file is damaged.
std::optional<EnvironmentMaps> readMaps(KeptResult kept);

} // namespace torrance
