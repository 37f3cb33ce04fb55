#include "view/error_survey.h"

#include "core/error.h"
#include "measure/image_metrics.h"
#include "reference/pixel_estimate.h"
#include "study/certificate.h"
#include "study/pixel_error.h"
#include "view/mean_norm.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace torrance {
namespace {

constexpr int kFirstStride = 16;     // pixels between those that are looked at first
constexpr double kNewsSeconds = 0.3; // between two that are announced
constexpr float kUncovered = std::numeric_limits<float>::quiet_NaN();

// A pixel stands for the square of its stride until others are known.
void fill(Image& image, int x, int y, int stride, float value)
{
    for (int v = y; v < std::min(y + stride, image.height); ++v)
        for (int u = x; u < std::min(x + stride, image.width); ++u)
            *image.at(u, v) = value;
}

} // namespace

void ErrorSurvey::start(const Scene& scene, const Camera& camera, const Settings& settings, Image drawn)
{
    requireCertifiable(scene, settings);
    stop();
    known = {};
    known.errors = Image(drawn.width, drawn.height, 1, kUncovered);
    isNew = false;
    stops = false;
    thread = std::thread([this, &scene, camera, settings, picture = std::move(drawn)] {
        try {
            run(scene, camera, settings, picture);
        } catch (const std::exception& error) {
            const std::lock_guard lock(mutex);
            known.problem = error.what();
            isNew = true;
        }
        announce();
    });
}

void ErrorSurvey::stop()
{
    stops = true;
    if (thread.joinable())
        thread.join();
}

bool ErrorSurvey::takeNews(State& state)
{
    const std::lock_guard lock(mutex);
    if (!isNew)
        return false;
    state = known;
    isNew = false;
    return true;
}

void ErrorSurvey::run(const Scene& scene, const Camera& camera, const Settings& settings, const Image& drawn)
{
    const ReferenceSettings exact = exactSettings(settings, {});
    const PixelEstimator estimator(scene, camera, exact);
    const double floor = kPixelFloor * coveredMeanNorm(estimator, drawn);
    double above = 0.0, below = 0.0, norms = 0.0, spread = 0.0;
    std::size_t looked = 0;
    auto lastNews = std::chrono::steady_clock::now();
    for (int stride = kFirstStride; stride >= 1; stride /= 2)
        for (int y = 0; y < drawn.height; y += stride)
            for (int x = 0; x < drawn.width; x += stride) {
                if (stops)
                    return;
                if (stride < kFirstStride && x % (2 * stride) == 0 && y % (2 * stride) == 0)
                    continue; // looked at with a greater stride
                ++looked;
                float error = kUncovered;
                if (estimator.seenFrom(x, y)) {
                    const float* texel = drawn.at(x, y);
                    const PixelError pixel =
                        pixelError(dvec3(texel[0], texel[1], texel[2]),
                                   estimator.replicates(x, y, exact.directions, exact.seed).colors);
                    error = static_cast<float>(pixel.above / (pixel.norm + floor));
                    above += pixel.above;
                    below += pixel.below;
                    norms += pixel.norm;
                    spread += std::sqrt(pixel.normVariance);
                }
                const std::lock_guard lock(mutex);
                fill(known.errors, x, y, stride, error);
                if (error == error)
                    ++known.pixels;
                if (norms > 0.0) {
                    known.mean = std::sqrt(std::max(above * below, 0.0)) / norms; // as PixelError::middle, of the sums
                    known.noise = spread / norms;
                }
                known.done = double(looked) / (double(drawn.width) * drawn.height);
                const auto now = std::chrono::steady_clock::now();
                if (std::chrono::duration<double>(now - lastNews).count() < kNewsSeconds)
                    continue;
                lastNews = now;
                isNew = true;
                announce();
            }
    const std::lock_guard lock(mutex);
    isNew = true;
}

} // namespace torrance
