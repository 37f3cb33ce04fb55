#include "view/panorama_thumbnails.h"

#include "core/error.h"
#include "core/log.h"
#include "image/quantize.h"
#include "image/srgb.h"
#include "view/panel_renderer.h"

#include <algorithm>

namespace torrance {
namespace {

constexpr int kWidth = 128;          // pixels
constexpr double kMiddleGrey = 0.18; // of the median

dvec3 meanUnder(const Image& radiance, int left, int right, int top, int bottom)
{
    dvec3 sum(0.0);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const float* texel = radiance.at(x, y);
            sum += dvec3(texel[0], texel[1], texel[2]);
        }
    return sum / double((right - left) * (bottom - top));
}

} // namespace

std::vector<std::uint8_t> panoramaCodes(const Image& radiance, int width)
{
    const int height = width / 2;
    std::vector<dvec3> colors;
    std::vector<double> brightness;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int left = x * radiance.width / width, top = y * radiance.height / height;
            colors.push_back(meanUnder(radiance, left, std::max((x + 1) * radiance.width / width, left + 1), top,
                                       std::max((y + 1) * radiance.height / height, top + 1)));
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
