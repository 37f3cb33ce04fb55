#include "passes/precision_probe.h"

#include "gpu/commands.h"
#include "gpu/guard.h"
#include "gpu/retype_shader.h"
#include "math/half.h"
#include "passes/fullscreen.h"
#include "passes/probe_row.h"
#include "passes/targets.h"
#include "shaders/shared/bindings.h"

#include <cmath>
#include <cstring>

namespace torrance {
namespace {

using gpu::Precision;

constexpr const char* kEntry = "passes/probe_precision.frag";

// Rows of one draw: up to 75 MB of table and 8 MB of targets.
constexpr std::size_t kMostRows = 256 * shared::kProbeWidth;

template <typename Scalar>
void append(std::vector<std::byte>& bytes, Scalar value)
{
    const auto* first = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof value);
}

std::vector<std::byte> packed(std::span<const brdf::ShadingPoint> points, Precision precision)
{
    std::vector<std::byte> bytes;
    bytes.reserve(points.size() * kProbeScalars * sizeof(double));
    for (const brdf::ShadingPoint& point : points)
        for (const double scalar : probeScalars(point))
            switch (precision) {
            case Precision::fp16:
                append(bytes, toHalf(static_cast<float>(scalar)));
                break;
            case Precision::fp32:
                append(bytes, static_cast<float>(scalar));
                break;
            case Precision::fp64:
                append(bytes, scalar);
            }
    return bytes;
}

gpu::ShaderSource sourceOf(gpu::ShaderLibrary& shaders, const ProbeTerm& term, Precision precision)
{
    gpu::ShaderSource source =
        gpu::retyped(shaders.gather(kEntry, "#define VALUE3 vec3\n" + term.selected), precision, {kEntry});
    if (precision == Precision::fp16)
        source.files[kEntry].insert(0, "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require\n"
                                       "#extension GL_EXT_shader_16bit_storage : require\n");
    return source;
}

std::string whyNot(const gpu::Device& device, const ProbeTerm& term, const gpu::ShaderSource& source,
                   Precision precision)
{
    const std::string bits = precision == Precision::fp16 ? "16" : "64";
    if (!device.computes(precision))
        return "the device does not compute in " + bits + " bits";
    if (term.readsTable)
        return "it looks up a table of 32-bit floats";
    std::string missing;
    bool several = false;
    for (const std::string& name : gpu::unavailableFunctions(source, precision)) {
        several = !missing.empty();
        missing += (several ? ", " : "") + name;
    }
    return missing.empty() ? missing : missing + (several ? " have no " : " has no ") + bits + "-bit form in GLSL";
}

std::vector<dvec3> draw(const gpu::Device& device, const PrecisionProbe& probe,
                        std::span<const brdf::ShadingPoint> points)
{
    const gpu::Buffer table =
        gpu::makeBuffer(device, packed(points, probe.precision), vk::BufferUsageFlagBits::eStorageBuffer, "probe rows");
    const int width = static_cast<int>(shared::kProbeWidth);
    const int height = static_cast<int>((points.size() + shared::kProbeWidth - 1) / shared::kProbeWidth);
    const gpu::DeviceImage values = makeColorTarget(device, width, height, "probe values");
    const gpu::DeviceImage rests = makeColorTarget(device, width, height, "probe rests");
    gpu::Commands commands(device);
    commands.use({}, {gpu::use(table, gpu::Access::shaderRead)});
    const gpu::DeviceImage* const targets[] = {&values, &rests};
    beginRendering(commands, targets, nullptr, kClearToNothing, LoadTarget::clear);
    gpu::Bindings bindings;
    bindings.set(shared::kBindProbeRows, table);
    drawFullscreen(commands, probe.pipeline, bindings);
    commands.buffer.endRendering();
    commands.submitAndWait();

    const Image high = readBack(device, values), low = readBack(device, rests);
    std::vector<dvec3> result(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = high.texels[4 * i + c]; // where it is not finite, nothing is left of it
            result[i][static_cast<int>(c)] = std::isfinite(value) ? value + low.texels[4 * i + c] : value;
        }
    return result;
}

} // namespace

std::variant<PrecisionProbe, std::string> makePrecisionProbe(const gpu::Device& device, gpu::ShaderLibrary& shaders,
                                                             const ProbeTerm& term, Precision precision)
{
    return gpu::guarded(device, [&]() -> std::variant<PrecisionProbe, std::string> {
        const gpu::ShaderSource source = sourceOf(shaders, term, precision);
        if (const std::string reason = whyNot(device, term, source, precision); !reason.empty())
            return reason;
        return PrecisionProbe{precision,
                              gpu::makePipeline(device, shaders.get("passes/fullscreen.vert", ""), shaders.get(source),
                                                {.name = "probe", .colorFormats = {kColorFormat, kColorFormat}})};
    });
}

std::vector<dvec3> probe(const gpu::Device& device, const PrecisionProbe& probe,
                         std::span<const brdf::ShadingPoint> points)
{
    return gpu::guarded(device, [&] {
        std::vector<dvec3> values;
        values.reserve(points.size());
        for (std::size_t first = 0; first < points.size(); first += kMostRows) {
            const auto part = draw(device, probe, points.subspan(first, std::min(kMostRows, points.size() - first)));
            values.insert(values.end(), part.begin(), part.end());
        }
        return values;
    });
}

} // namespace torrance
