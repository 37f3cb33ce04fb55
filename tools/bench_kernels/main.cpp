// The kernels that prepare a picture on the processor, by Google Benchmark. Each says what one of its items (a texel, a
// triangle, a pixel) takes of all processors together, and what it would take if nothing but memory set the pace: the
// bytes that must be read and written once, at the pace of a copy that this program measures first, on as many threads.
#include "core/parallel.h"
#include "core/process_usage.h"
#include "files/image_encoders.h"
#include "image/code_rows.h"
#include "image/display.h"
#include "math/latlong.h"
#include "prepare/environment_maps.h"
#include "prepare/irradiance.h"
#include "prepare/texture_levels.h"
#include "scene/camera_fit.h"
#include "scene/camera_view.h"
#include "scene/shape_mesh.h"
#include "scene/tangents.h"
#include "scene/visible_triangles.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

namespace torrance {
namespace {

constexpr int kTextureSide = 2048;
constexpr int kPanoramaWidth = 1024;
constexpr int kPictureSide = 1024;

/// Processor seconds of all threads for a byte that is read and one that is written: the best of a few copies of more
/// than any cache holds.
double secondsPerCopiedByte()
{
    static const double seconds = [] {
        constexpr std::size_t kBytes = std::size_t(256) << 20, kPiece = std::size_t(4) << 20;
        const std::vector<std::byte> from(kBytes, std::byte{1});
        std::vector<std::byte> to(kBytes);
        double best = 1.0;
        for (int i = 0; i < 5; ++i) {
            const double start = timeUse().processor;
            parallelFor(kBytes / kPiece, 1,
                        [&](std::size_t piece) { std::memcpy(&to[piece * kPiece], &from[piece * kPiece], kPiece); });
            best = std::min(best, timeUse().processor - start);
            benchmark::DoNotOptimize(to.data());
        }
        return best / double(kBytes);
    }();
    return seconds;
}

/// Runs it as often as the benchmark likes. `bytes` are those read and those written, together, for all items.
template <typename Work>
void measure(benchmark::State& state, double items, double bytes, Work work)
{
    work(); // memory is there, tables are made
    double seconds = 0.0, runs = 0.0;
    for (auto _ : state) {
        const double start = timeUse().processor;
        work();
        seconds += timeUse().processor - start;
        ++runs;
    }
    state.counters["items"] = items;
    state.counters["ns_an_item"] = 1e9 * seconds / (runs * items);
    state.counters["memory_ns_an_item"] = 1e9 * 0.5 * bytes * secondsPerCopiedByte() / items; // a copy does both
}

TextureImage noisyTexture()
{
    TextureImage image = {.name = "noise", .width = kTextureSide, .height = kTextureSide, .texels = {}};
    image.texels.resize(std::size_t(kTextureSide) * kTextureSide * 4);
    std::mt19937 random(1);
    for (std::byte& code : image.texels)
        code = std::byte(random() & 0xff);
    return image;
}

void mips(benchmark::State& state, TexelContent content)
{
    const TextureImage image = noisyTexture();
    const MipRule rule = {.content = content};
    constexpr std::size_t kTexelBytes = 8; // four channels of 16 bits, whichever they are
    std::vector<std::vector<std::byte>> memory;
    std::vector<LevelMemory> levels;
    double bytes = double(image.texels.size());
    for (int level = 0; level < mipCount(image.width, image.height); ++level) {
        const std::size_t side = std::size_t(kTextureSide) >> level;
        memory.emplace_back(side * side * kTexelBytes);
        levels.push_back({memory.back().data(), side * kTexelBytes});
        bytes += double(memory.back().size());
    }
    measure(state, double(kTextureSide) * kTextureSide, bytes, [&] { writeLevels(image, rule, levels); });
}

/// Bright on one side, with a small sun.
Image panorama()
{
    Image image(kPanoramaWidth, kPanoramaWidth / 2, 3);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double azimuth = 2.0 * kPi * (x + 0.5) / image.width, polar = kPi * (y + 0.5) / image.height;
            const bool sun = x > 300 && x < 310 && y > 100 && y < 110;
            for (int c = 0; c < 3; ++c)
                image.at(x, y)[c] = float(1.0 + std::sin(azimuth) * std::sin(polar) + (sun ? 1000.0 : 0.0));
        }
    return image;
}

void prefilter(benchmark::State& state)
{
    const Image radiance = panorama();
    const EnvironmentMaps maps = makeEnvironmentMaps(radiance);
    double texels = 0.0, bytes = 4.0 * double(radiance.texels.size());
    for (const CubeLevels* cube : {&maps.specular, &maps.irradiance})
        for (const std::vector<float>& level : cube->data) {
            texels += double(level.size()) / 4.0;
            bytes += 4.0 * double(level.size());
        }
    measure(state, texels, bytes, [&] { benchmark::DoNotOptimize(makeEnvironmentMaps(radiance)); });
}

void harmonics(benchmark::State& state)
{
    const Image radiance = panorama();
    measure(state, double(radiance.width) * radiance.height, 4.0 * double(radiance.texels.size()),
            [&] { benchmark::DoNotOptimize(irradianceHarmonics(radiance)); });
}

Image picture()
{
    Image image(kPictureSide, kPictureSide, 4, 1.0f);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c)
                image.at(x, y)[c] = float(x + 3 * y + c) / 2000.0f;
    return image;
}

void display(benchmark::State& state)
{
    const Image linear = picture();
    const DisplaySettings settings;
    const double pixels = double(linear.width) * linear.height;
    measure(state, pixels, pixels * (16.0 + 4.0),
            [&] { benchmark::DoNotOptimize(allCodes(displayRows(linear, settings, 8))); });
}

void encode(benchmark::State& state)
{
    const Image linear = picture();
    const CodeRows shown = displayRows(linear, {}, 8);
    const std::vector<std::uint8_t> codes = allCodes(shown);
    CodeRows kept = shown;
    kept.row = [&](int y, std::uint8_t* to) {
        std::memcpy(to, codes.data() + std::size_t(y) * shown.rowBytes(), shown.rowBytes());
    };
    const double pixels = double(linear.width) * linear.height;
    measure(state, pixels, double(codes.size() + encodePng(kept).size()),
            [&] { benchmark::DoNotOptimize(encodePng(kept)); });
}

void tangents(benchmark::State& state)
{
    Primitive sphere = sphereMesh();
    sphere.tangents.clear();
    const double vertices = double(sphere.positions.size());
    measure(state, double(sphere.indices.size()) / 3.0,
            vertices * (12.0 + 12.0 + 8.0 + 16.0) + 2.0 * 4.0 * double(sphere.indices.size()),
            [&] { benchmark::DoNotOptimize(makeTangents(sphere, 0, glm::dmat3x2(1.0))); });
}

void culling(benchmark::State& state)
{
    const Primitive sphere = sphereMesh();
    Camera camera = orbitCamera({0.4, 1.1}, 8.0, dvec3(0.0), 0.7);
    const dmat4 clip = projectionMatrix(camera, 1.0) * dmat4(dmat3(viewFromWorld(camera)));
    const auto view =
        triangleView({mat4(clip), mat3(1.0f), vec3(-cameraPosition(camera))}, {sphere.boundsMin, sphere.boundsMax},
                     ivec2(kPictureSide), VisibleSides::counterClockwise, 8);
    std::vector<vec2> places(sphere.positions.size());
    std::vector<std::uint32_t> kept(sphere.indices.size());
    measure(state, double(sphere.indices.size()) / 3.0,
            double(sphere.positions.size()) * (12.0 + 2.0 * 8.0) + 4.0 * 1.5 * double(sphere.indices.size()), [&] {
                placeVertices(*view, sphere.positions, places);
                benchmark::DoNotOptimize(keepVisible(*view, sphere.indices, places, kept.data()));
            });
}

BENCHMARK_CAPTURE(mips, colour, TexelContent::color)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mips, data, TexelContent::data)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mips, normal, TexelContent::normal)->Unit(benchmark::kMillisecond);
BENCHMARK(prefilter)->Unit(benchmark::kMillisecond);
BENCHMARK(harmonics)->Unit(benchmark::kMillisecond);
BENCHMARK(display)->Unit(benchmark::kMillisecond);
BENCHMARK(encode)->Unit(benchmark::kMillisecond);
BENCHMARK(tangents)->Unit(benchmark::kMillisecond);
BENCHMARK(culling)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace torrance

BENCHMARK_MAIN();
