#include "study/curve_error.h"

#include "image/srgb.h"
#include "math/norm.h"
#include "measure/flip.h"
#include "measure/image_metrics.h"
#include "measure/statistics.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

dvec3 shown(const dvec3& display)
{
    return glm::clamp(display, dvec3(0.0), dvec3(1.0));
}

dvec3 decoded(const dvec3& encoded)
{
    return {srgbDecode(encoded.r), srgbDecode(encoded.g), srgbDecode(encoded.b)};
}

dvec3 exactLight(const brdf::Method& method, const dvec3& color)
{
    if (method.slot == brdf::Slot::tone)
        return shown(findToneCurve(method.id)->exact(color));
    return decoded(shown(std::get<brdf::CurveFormula>(method.formula)(shown(color))));
}

// By the way of every picture: toDisplay.
Image drawnLight(const Image& colors, const brdf::Method& method)
{
    DisplaySettings settings = displayOf(method);
    if (method.slot == brdf::Slot::tone)
        settings.transfer = findTransferCurve("linear");
    else
        settings.tone = findToneCurve("none");
    Image light = toDisplay(colors, settings);
    for (float& value : light.texels)
        value = std::clamp(value, 0.0f, 1.0f);
    if (method.slot == brdf::Slot::transfer)
        for (float& value : light.texels)
            value = static_cast<float>(srgbDecode(double(value)));
    return light;
}

Image threeChannels(const Image& picture)
{
    Image colors(picture.width, picture.height, 3);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            std::copy_n(picture.at(x, y), 3, colors.at(x, y));
    return colors;
}

} // namespace

DisplaySettings displayOf(const brdf::Method& method)
{
    DisplaySettings settings;
    if (method.slot == brdf::Slot::tone)
        settings.tone = findToneCurve(method.id);
    else
        settings.transfer = findTransferCurve(method.id);
    return settings;
}

CurveJudgement judgeCurve(const Image& sceneLinear, const brdf::Method& method, const brdf::Method& truth)
{
    const Image colors = threeChannels(sceneLinear), test = drawnLight(colors, method);
    Image exact(colors.width, colors.height, 3);
    for (std::size_t i = 0; i < exact.texels.size(); i += 3) {
        const dvec3 light = exactLight(truth, dvec3(colors.texels[i], colors.texels[i + 1], colors.texels[i + 2]));
        for (std::size_t c = 0; c < 3; ++c)
            exact.texels[i + c] = static_cast<float>(light[static_cast<int>(c)]);
    }
    const ImageMetrics metrics = compareImages(exact, test);
    CurveJudgement result = {{}, Image(colors.width, colors.height, 1)};
    result.error = {.mean = metrics.meanError,
                    .rms = 0.0,
                    .worst = metrics.worst.error,
                    .flip = mean(ldrFlip(exact, test).texels),
                    .noise = 0.0,
                    .cells = {},
                    .cellWorst = {}};
    double norms = 0.0, squares = 0.0;
    const std::size_t count = result.pixels.texels.size();
    for (std::size_t i = 0; i < count; ++i)
        norms += norm1(&exact.texels[3 * i], 3);
    for (std::size_t i = 0; i < count; ++i) {
        const float *c = &exact.texels[3 * i], *d = &test.texels[3 * i];
        const double relative = distance1(c, d, 3) / (norm1(c, 3) + kPixelFloor * norms / double(count));
        result.pixels.texels[i] = static_cast<float>(relative);
        squares += relative * relative;
    }
    result.error.rms = std::sqrt(squares / double(count));
    return result;
}

} // namespace torrance
