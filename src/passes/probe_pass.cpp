#include "passes/probe_pass.h"

#include "brdf/dfg.h"
#include "gpu/commands.h"
#include "gpu/guard.h"
#include "gpu/pipeline.h"
#include "passes/dfg_upload.h"
#include "passes/fullscreen.h"
#include "passes/probe_row.h"
#include "passes/sampler.h"
#include "passes/targets.h"
#include "shaders/shared/bindings.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace torrance {
namespace {

// Rows of one draw: 67 MB of table and 4 MB of target.
constexpr std::size_t kMostRows = 256 * shared::kProbeWidth;

shared::ProbeRow rounded(const brdf::ShadingPoint& point)
{
    std::array<float, kProbeScalars> floats;
    std::ranges::transform(probeScalars(point), floats.begin(), [](double x) { return static_cast<float>(x); });
    return std::bit_cast<shared::ProbeRow>(floats);
}

// The table of directional albedos as the renderer binds it.
struct AlbedoTable
{
    gpu::DeviceImage image;
    vk::raii::Sampler sampler;
};

Image draw(const gpu::Device& device, const gpu::Pipeline& pipeline, const std::optional<AlbedoTable>& albedos,
           std::span<const brdf::ShadingPoint> points)
{
    std::vector<shared::ProbeRow> rows(points.size());
    std::ranges::transform(points, rows.begin(), rounded);
    const gpu::Buffer table =
        gpu::makeBuffer(device, std::as_bytes(std::span(rows)), vk::BufferUsageFlagBits::eStorageBuffer, "probe rows");
    const int height = static_cast<int>((points.size() + shared::kProbeWidth - 1) / shared::kProbeWidth);
    const gpu::DeviceImage target =
        makeColorTarget(device, static_cast<int>(shared::kProbeWidth), height, "probe values");

    gpu::Commands commands(device);
    commands.use({}, {gpu::use(table, gpu::Access::shaderRead)});
    if (albedos)
        commands.use({gpu::use(albedos->image, gpu::Access::sampled)});
    const gpu::DeviceImage* const targets[] = {&target};
    beginRendering(commands, targets, nullptr, kClearToNothing, LoadTarget::clear);
    gpu::Bindings bindings;
    bindings.set(shared::kBindProbeRows, table);
    if (albedos)
        bindings.set(shared::kBindDfg, albedos->image, albedos->sampler);
    drawFullscreen(commands, pipeline, bindings);
    commands.buffer.endRendering();
    commands.submitAndWait();
    return readBack(device, target);
}

} // namespace

std::vector<vec3> probe(const gpu::Device& device, gpu::ShaderLibrary& shaders, const ProbeTerm& term,
                        std::span<const brdf::ShadingPoint> points)
{
    return gpu::guarded(device, [&] {
        const gpu::Pipeline pipeline = gpu::makePipeline(device, shaders.get("passes/fullscreen.vert", term.selected),
                                                         shaders.get("passes/probe.frag", term.selected),
                                                         {.name = "probe", .colorFormats = {kColorFormat}});
        std::optional<AlbedoTable> albedos;
        if (term.readsTable)
            albedos.emplace(uploadDfgTable(device, *brdf::findDfgTable(term.table)), makeTableSampler(device));
        std::vector<vec3> values;
        values.reserve(points.size());
        for (std::size_t first = 0; first < points.size(); first += kMostRows) {
            const auto part = points.subspan(first, std::min(kMostRows, points.size() - first));
            const Image image = draw(device, pipeline, albedos, part);
            for (std::size_t i = 0; i < part.size(); ++i)
                values.emplace_back(image.texels[4 * i], image.texels[4 * i + 1], image.texels[4 * i + 2]);
        }
        return values;
    });
}

} // namespace torrance
