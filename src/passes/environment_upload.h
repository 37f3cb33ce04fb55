// Environments and the tables of their light on the device: only what a plan uses, each made once.
#pragma once

#include "brdf/dfg.h"
#include "core/content_hash.h"
#include "core/disk_cache.h"
#include "gpu/image.h"
#include "passes/light_cubes.h"
#include "plan/shading_plan.h"
#include "prepare/environment_lamps.h"

#include <array>
#include <filesystem>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace torrance {

/// What surfaces of one choice bind; null where there is no use for it. Owned by the store.
struct EnvironmentImages
{
    const gpu::DeviceImage* specular = nullptr; // cube, prefiltered chain
    const gpu::DeviceImage* diffuse = nullptr;  // cube, irradiance / pi; or, for the methods sh4, sh9, sh9_windowed,
    std::array<vec3, 9> harmonics = {};         // the same as nine harmonics
    const gpu::DeviceImage* radiance = nullptr; // cube with plain mips, for methods that draw samples
    const gpu::DeviceImage* lamps = nullptr;    // what was taken out of it, as environment_lamps.h has it
    std::span<const brdf::LampPoint> lampPoints = {};
    LampDensities lampDensities;
    const gpu::DeviceImage* panorama = nullptr;   // lat-long, with mips: seen behind the scene, or in its mirrors
    const gpu::DeviceImage* background = nullptr; // cube, prefiltered chain: what is seen behind the scene in its place
    const gpu::DeviceImage* dfg = nullptr;        // directional albedos
};

/// An environment of which lamps were taken out.
struct LampImages
{
    gpu::DeviceImage rest, lamps;
    std::vector<brdf::LampPoint> points;
    LampDensities densities;
};

class EnvironmentStore
{
public:
    /// `cacheFolder` keeps prefiltered environments by their content; empty: they are made anew in every process.
    EnvironmentStore(const gpu::Device& device, const std::filesystem::path& cacheFolder);

    /// By ShadingPlan::choices. From any thread.
    std::vector<EnvironmentImages> get(const Scene& scene, const ShadingPlan& plan);

private:
    void addLight(EnvironmentImages& images, const Image& radiance, const ContentHash& content,
                  const Settings& settings);
    const LightCubes& lightCubes(const Image& radiance, const ContentHash& content, const brdf::Method& specular);
    const gpu::DeviceImage& radianceCube(const Image& radiance, const ContentHash& content, int size);
    const LampImages& lamps(const Image& radiance, const ContentHash& content, int size, int points);
    std::vector<float> cubeTexels(const Image& radiance, const ContentHash& content, int size);
    const gpu::DeviceImage& panorama(const Image& radiance, const ContentHash& content);
    const gpu::DeviceImage* albedoTable(const brdf::Preset& methods); // null for a fit

    const gpu::Device& device;
    std::mutex mutex; // held by get
    DiskCache cache;
    std::map<std::string, gpu::DeviceImage> radianceCubes;     // by the panorama's content and the faces' size
    std::map<std::string, LampImages> lampImages;              // likewise, and by the number of points
    std::map<std::string, gpu::DeviceImage> panoramas;         // by the panorama's content
    std::map<std::string, LightCubes> cubes;                   // likewise, and by the source's model that owns them
    std::map<std::string_view, gpu::DeviceImage> albedoTables; // by the row, and source B's
};

} // namespace torrance
