#include "files/image_write.h"

#include "core/atomic_write.h"
#include "core/error.h"
#include "core/nearest_name.h"
#include "core/standard_output.h"
#include "files/hdr_file.h"
#include "files/image_encoders.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

namespace torrance {
namespace {

constexpr std::pair<const char*, ImageFormat> kExtensions[] = {
    {".png", ImageFormat::png},   {".jpg", ImageFormat::jpeg}, {".jpeg", ImageFormat::jpeg},
    {".webp", ImageFormat::webp}, {".exr", ImageFormat::exr},  {".hdr", ImageFormat::hdr},
};

std::string lowered(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

CodeRows displayed(const Image& beauty, const WriteSettings& settings, AlphaRule alpha)
{
    return displayRows(
        beauty, {.exposure = settings.exposure, .tone = settings.tone, .transfer = settings.transfer, .alpha = alpha},
        settings.bitsPerChannel);
}

ImageLayer beautyLayer(const Image& beauty)
{
    std::vector<std::string> channels = {"R", "G", "B"};
    if (beauty.channels == 4)
        channels.emplace_back("A");
    return {.name = "", .channels = std::move(channels), .image = beauty};
}

void checkSettings(ImageFormat format, std::span<const ImageLayer> extra, const WriteSettings& settings)
{
    if (settings.bitsPerChannel == 16 && format != ImageFormat::png)
        throw usageError("16 bits a channel are for PNG", "write PNG, or EXR for float");
    if (!extra.empty() && format != ImageFormat::exr)
        throw usageError("layers are for EXR", "name the output .exr");
}

} // namespace

ImageFormat imageFormatOf(const std::string& path)
{
    if (path == "-")
        return ImageFormat::png;
    const std::string extension = lowered(std::filesystem::path(path).extension().string());
    std::vector<std::string> known;
    for (const auto& [name, format] : kExtensions) {
        if (extension == name)
            return format;
        known.emplace_back(name);
    }
    const std::string nearest = nearestName(extension, known);
    throw usageError(path + ": unknown picture format",
                     (nearest.empty() ? "" : "did you mean " + nearest + "? ") + "known are .png .jpg .webp .exr .hdr");
}

bool isSceneLinear(ImageFormat format)
{
    return format == ImageFormat::exr || format == ImageFormat::hdr;
}

std::vector<std::byte> encodePicture(ImageFormat format, const Image& beauty, std::span<const ImageLayer> extra,
                                     const WriteSettings& settings)
{
    checkSettings(format, extra, settings);
    switch (format) {
    case ImageFormat::png:
        return encodePng(displayed(beauty, settings, AlphaRule::straight));
    case ImageFormat::jpeg:
        return encodeJpeg(displayed(beauty, settings, AlphaRule::overBlack), settings.quality);
    case ImageFormat::webp:
        return encodeWebp(displayed(beauty, settings, AlphaRule::straight), settings.quality);
    case ImageFormat::hdr:
        return encodeHdr(beauty);
    case ImageFormat::exr:
        break;
    }
    std::vector<ImageLayer> layers = {beautyLayer(beauty)};
    layers.insert(layers.end(), extra.begin(), extra.end());
    return encodeExr(layers, settings.attributes);
}

void writePicture(const std::string& path, const Image& beauty, std::span<const ImageLayer> extra,
                  const WriteSettings& settings)
{
    const std::vector<std::byte> bytes = encodePicture(imageFormatOf(path), beauty, extra, settings);
    if (path == "-")
        writeStandardOutput(bytes);
    else
        writeFile(path, bytes);
}

} // namespace torrance
