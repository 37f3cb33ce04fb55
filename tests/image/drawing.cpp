#include "drawing.h"

#include "files/image_write.h"
#include "gpu/test_device.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <sstream>

namespace torrance::test {
namespace {

std::unique_ptr<Renderer> theRenderer;

/// One renderer for all tests: what a pipeline costs is paid once. It goes before the device does.
Renderer& renderer()
{
    if (!theRenderer)
        theRenderer = std::make_unique<Renderer>(device(), shaders(), std::filesystem::path());
    return *theRenderer;
}

class RendererEnd : public testing::Environment
{
    void TearDown() override { theRenderer.reset(); }
};

const testing::Environment* const kRendererEnd = testing::AddGlobalTestEnvironment(new RendererEnd);

} // namespace

Settings settingsOf(std::string_view preset, int size)
{
    Settings settings;
    settings.methods = *brdf::findPreset(preset);
    settings.width = size;
    settings.height = size;
    settings.background = BackgroundKind::transparent;
    return settings;
}

Picture draw(const Scene& scene, const Camera& camera, const Settings& settings)
{
    const ShadingPlan plan = makePlan(scene, settings);
    const DeviceScene onDevice = renderer().upload(scene, plan);
    return renderer().render(onDevice, camera);
}

brdf::Preset plannedMethods(const Scene& scene, const Settings& settings, int material)
{
    brdf::Preset methods = settings.methods;
    const ShadingPlan plan = makePlan(scene, settings);
    if (!plan.materials[static_cast<std::size_t>(material)].compensates)
        methods.multipleScattering = brdf::findMethod(brdf::Slot::multipleScattering, "none");
    return methods;
}

dvec4 pixelOf(const Picture& picture, int x, int y)
{
    const float* p = picture.color.at(x, y);
    return dvec4(p[0], p[1], p[2], p[3]);
}

void Worst::note(int px, int py, const dvec3& drawnColor, const dvec3& exactColor, const dvec3& allowedError)
{
    for (int c = 0; c < 3; ++c) {
        const double error = std::abs(drawnColor[c] - exactColor[c]);
        // A NaN is worse than any number.
        const double ratio = std::isfinite(error) ? error / allowedError[c] : std::numeric_limits<double>::infinity();
        if (ratio <= excess)
            continue;
        *this = {ratio, px, py, drawnColor, exactColor, allowedError};
    }
}

std::string Worst::text() const
{
    std::ostringstream out;
    out.precision(9);
    const auto color = [&](const char* name, const dvec3& c) {
        out << ' ' << name << " (" << c.r << ", " << c.g << ", " << c.b << ')';
    };
    out << "worst pixel (" << x << ", " << y << "), " << excess << " of what is allowed:";
    color("drawn", drawn);
    color("exact", exact);
    color("allowed", allowed);
    return out.str();
}

std::string keepFailure(const std::string& name, const Image& drawn, const Image& exact)
{
    const std::filesystem::path folder = std::filesystem::path(TORRANCE_BINARY_DIR) / "image-failures";
    std::filesystem::create_directories(folder);
    writePicture((folder / (name + "-drawn.exr")).string(), drawn, {}, {});
    writePicture((folder / (name + "-exact.exr")).string(), exact, {}, {});
    return (folder / name).string() + "-{drawn,exact}.exr";
}

} // namespace torrance::test
