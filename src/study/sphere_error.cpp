#include "study/sphere_error.h"

#include "math/replicates.h"
#include "measure/flip.h"
#include "measure/image_metrics.h"
#include "measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torrance {
namespace {

struct Pixel
{
    int x, y;
    std::size_t cell;
    double difference, norm, noise;
};

std::vector<Pixel> comparedPixels(const MethodGrid& grid, const SphereTruth& truth, const Image& drawn)
{
    std::vector<Pixel> pixels;
    for (int y = 0; y < drawn.height; ++y)
        for (int x = 0; x < drawn.width; ++x) {
            const auto seen = spherePixel(grid, x, y);
            if (!seen)
                continue;
            Pixel pixel = {x, y, grid.cell(seen->reflectance, seen->roughness, seen->column), 0.0, 0.0, 0.0};
            for (int c = 0; c < 3; ++c) {
                const double exact = truth.color.at(x, y)[c];
                const double difference = std::abs(drawn.at(x, y)[c] - exact);
                pixel.difference += std::isfinite(difference) ? difference : HUGE_VAL;
                pixel.norm += std::abs(exact);
            }
            if (!truth.variance.texels.empty()) {
                const float* v = truth.variance.at(x, y);
                pixel.noise = halfWidth95(dvec3(v[0], v[1], v[2]));
            }
            pixels.push_back(pixel);
        }
    return pixels;
}

// Black but for a rounding: no share can be told of it.
constexpr double kLeastLight = 1e-12;

void fillCells(const MethodGrid& grid, const std::vector<Pixel>& pixels, const Image& relative, MethodError& error)
{
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> differences(grid.cells()), norms(grid.cells());
    error.cellWorst.assign(grid.cells(), 0.0);
    for (const Pixel& pixel : pixels) {
        differences[pixel.cell] += pixel.difference;
        norms[pixel.cell] += pixel.norm;
        error.cellWorst[pixel.cell] = std::max(error.cellWorst[pixel.cell], double(*relative.at(pixel.x, pixel.y)));
    }
    for (std::size_t i = 0; i < grid.cells(); ++i) {
        const bool lit = norms[i] > kLeastLight;
        error.cells.push_back(lit ? differences[i] / norms[i] : kNothing);
        if (!lit)
            error.cellWorst[i] = kNothing;
    }
}

// FLIP knows nothing of pixels that do not count: there both are alike.
double meanFlip(const std::vector<Pixel>& pixels, const SphereTruth& truth, const Image& drawn)
{
    Image test = truth.color;
    for (const Pixel& pixel : pixels)
        for (int c = 0; c < 3; ++c) {
            const float value = drawn.at(pixel.x, pixel.y)[c];
            test.at(pixel.x, pixel.y)[c] = std::isfinite(value) ? value : 0.0f;
        }
    return mean(hdrFlip(truth.color, test).texels);
}

} // namespace

SphereJudgement judgeSpheres(const MethodGrid& grid, const SphereTruth& truth, const Image& drawn)
{
    const std::vector<Pixel> pixels = comparedPixels(grid, truth, drawn);
    double differences = 0.0, norms = 0.0, noise = 0.0, squares = 0.0;
    for (const Pixel& pixel : pixels) {
        differences += pixel.difference;
        norms += pixel.norm;
        noise += pixel.noise;
    }
    const auto count = static_cast<double>(pixels.size());
    SphereJudgement result = {{}, Image(drawn.width, drawn.height, 1)};
    for (const Pixel& pixel : pixels) {
        const double relative = pixel.difference / (pixel.norm + kPixelFloor * norms / count);
        *result.pixels.at(pixel.x, pixel.y) = static_cast<float>(relative);
        squares += relative * relative;
        result.error.worst = std::max(result.error.worst, relative);
    }
    result.error.mean = differences / norms;
    result.error.rms = std::sqrt(squares / count);
    result.error.noise = noise / norms;
    result.error.flip = meanFlip(pixels, truth, drawn);
    fillCells(grid, pixels, result.pixels, result.error);
    return result;
}

} // namespace torrance
