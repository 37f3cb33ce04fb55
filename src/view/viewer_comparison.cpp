// What the picture in the window is compared with.
#include "view/viewer.h"

#include "files/image_read.h"
#include "image/srgb.h"
#include "passes/targets.h"

#include <fmt/format.h>

namespace torrance {

void Viewer::handle(const KeepPicture&)
{
    if (!state.scene)
        return;
    const gpu::DeviceImage& drawn = renderer.frame(state.scene->plan);
    swapchain.waitUntilIdle(); // the old one may still be shown
    compared = {};
    compared.image = makeColorTarget(device, static_cast<int>(drawn.shape.width), static_cast<int>(drawn.shape.height),
                                     "kept picture");
    gpu::Commands commands(device);
    gpu::copyImage(commands, drawn, compared.image);
    commands.submitAndWait();
    compared.curves = shownCurves();
    compared.term = shownTerm;
    state.compared = "the picture that was kept";
}

void Viewer::handle(const OpenPicture& request)
{
    if (!state.scene)
        return;
    ReadImage read = readImage(request.file);
    const bool codes = read.displayReferred;
    const Image color = colorOf(std::move(read), request.file);
    Image opaque(color.width, color.height, 4, 1.0f);
    for (std::size_t i = 0; i < color.texels.size() / 3; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            opaque.texels[4 * i + c] = codes ? srgbDecode(color.texels[3 * i + c]) : color.texels[3 * i + c];
    swapchain.waitUntilIdle();
    compared = {};
    compared.curves = codes ? DisplaySettings{.tone = findToneCurve("none")} : shownCurves();
    compared.image = makeColorTarget(device, color.width, color.height, "picture to compare with");
    const gpu::Buffer texels =
        gpu::makeStagingBuffer(device, std::as_bytes(std::span(opaque.texels)), "picture to compare with");
    gpu::Commands commands(device);
    gpu::copyToImage(commands, texels, compared.image, 4 * sizeof(float));
    commands.submitAndWait();
    state.compared = request.file;
    if (ivec2(color.width, color.height) != area.size)
        state.notice =
            fmt::format("the file is {} x {} and the picture {} x {}: shown pixel by pixel from the top left",
                        color.width, color.height, area.size.x, area.size.y);
}

} // namespace torrance
