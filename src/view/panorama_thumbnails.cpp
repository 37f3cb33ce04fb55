#include "view/panorama_thumbnails.h"

#include "core/error.h"
#include "core/log.h"
#include "image/quantize.h"
#include "image/srgb.h"
#include "view/panel_renderer.h"
#include "view/pixels_under.h"

#include <algorithm>

namespace torrance {
namespace {

constexpr int kWidth = 128;          // pixels
constexpr double kMiddleGrey = 0.18; // of the median

dvec3 meanOver(const Image& radiance, const PixelBox& box)
{
    dvec3 sum(0.0);
    for (int y = box.first.y; y < box.beyond.y; ++y)
        for (int x = box.first.x; x < box.beyond.x; ++x) {
            const float* texel = radiance.at(x, y);
            sum += dvec3(texel[0], texel[1], texel[2]);
        }
    const ivec2 sides = box.beyond - box.first;
    return sum / (double(sides.x) * sides.y);
}

} // namespace

std::vector<std::uint8_t> panoramaCodes(const Image& radiance, int width)
{
    const int height = width / 2;
    std::vector<dvec3> colors;
    std::vector<double> brightness;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            colors.push_back(meanOver(radiance, pixelsUnder(x, y, {width, height}, {radiance.width, radiance.height})));
            brightness.push_back((colors.back().x + colors.back().y + colors.back().z) / 3.0);
        }
    const auto middle = brightness.begin() + std::ptrdiff_t(brightness.size() / 2);
    std::ranges::nth_element(brightness, middle);
    const double gain = *middle > 0.0 ? kMiddleGrey / *middle : 1.0;
    std::vector<std::uint8_t> codes;
    for (const dvec3& color : colors) {
        for (int c = 0; c < 3; ++c)
            codes.push_back(static_cast<std::uint8_t>(
                quantized(srgbEncode(static_cast<float>(std::min(gain * color[c], 1.0))), 255)));
        codes.push_back(255);
    }
    return codes;
}

const gpu::DeviceImage* PanoramaThumbnails::get(const std::string& name)
{
    if (const auto found = pictures.find(name); found != pictures.end())
        return &found->second;
    if (known.insert(name).second)
        asked.push_back(name);
    return nullptr;
}

void PanoramaThumbnails::step()
{
    try {
        if (const auto codes = task.take(); codes && !codes->empty())
            pictures.emplace(begun, uploadPanelPicture(device, kWidth, kWidth / 2, std::as_bytes(std::span(*codes)),
                                                       "environment's thumbnail"));
    } catch (const Error& error) {
        if (error.exitCode == ExitCode::deviceFailure)
            throw;
        logWarning(error.what()); // whoever chooses it hears of it in the window
    }
    if (task.isRunning() || asked.empty())
        return;
    begun = asked.front();
    asked.erase(asked.begin());
    task.start([this, name = begun](Progress&) {
        const std::optional<Environment> environment = load(name);
        return environment ? panoramaCodes(environment->radiance, kWidth) : std::vector<std::uint8_t>();
    });
}

} // namespace torrance
