#include "app/bench_session.h"
#include "app/bench_text.h"
#include "app/device_option.h"
#include "app/progress_line.h"
#include "files/image_write.h"
#include "passes/renderer.h"
#include "study/soak.h"

namespace torrance {
namespace {

std::string readingsAsCsv(const std::vector<MemoryUse>& readings)
{
    std::string text = "render,own_bytes,allocated_bytes,pss_bytes\n";
    for (std::size_t i = 0; i < readings.size(); ++i)
        text += std::to_string(i + 1) + "," + std::to_string(readings[i].own) + "," +
                std::to_string(readings[i].allocated) + "," + std::to_string(readings[i].proportional) + "\n";
    return text;
}

Json asJson(const MemoryUse& use)
{
    return Json::Object{{"own_bytes", std::size_t(use.own)},
                        {"allocated_bytes", std::size_t(use.allocated)},
                        {"pss_bytes", std::size_t(use.proportional)}};
}

// From the file to the bytes of a PNG, and all of it given back.
void renderOnce(Renderer& renderer, const BenchSource& source)
{
    const Scene scene = source.load();
    const ShadingPlan plan = makePlan(scene, source.settings);
    const DeviceScene onDevice = renderer.upload(scene, plan);
    const Picture picture = renderer.render(onDevice, source.camera(scene));
    encodePicture(ImageFormat::png, picture.color, {}, {});
}

} // namespace

ExitCode benchSoak(BenchSession& session)
{
    const std::vector<BenchSource> sources = benchSources(session.options, session.variants, session.environment);
    const int renders = session.options.soak;
    Renderer renderer(session.device, session.shaders, cacheFolder(session.global));
    ProgressLine progress("renders");
    const std::vector<MemoryUse> readings = soak(renders, [&](int i) {
        renderOnce(renderer, sources[static_cast<std::size_t>(i) % sources.size()]);
        progress.show(i + 1, renders);
    });
    progress.clear();
    const SoakVerdict verdict = judgeSoak(readings);
    session.say(textOf(verdict, readings.size()));
    writeJson(session.global.json, Json::Object{{"schema", "torrance-bench-soak/1"},
                                                {"program", session.emptyRecord().program},
                                                {"renders", renders},
                                                {"after_warm_up", asJson(verdict.afterWarmUp)},
                                                {"at_end", asJson(verdict.atEnd)},
                                                {"growth", verdict.growth},
                                                {"passed", verdict.passed()}});
    session.writeCsv(readingsAsCsv(readings));
    return verdict.passed() ? ExitCode::success : ExitCode::checkFailed;
}

} // namespace torrance
