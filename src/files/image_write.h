// A picture to a file, in the format that the file's name asks for.
#pragma once

#include "files/exr_file.h"
#include "image/display.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace torrance {

enum class ImageFormat
{
    png,
    jpeg,
    webp,
    exr,
    hdr,
};

/// By the extension, in either case; "-" is PNG. An Error (usage) that names the known ones where it is none of them.
ImageFormat imageFormatOf(const std::string& path);

/// EXR and HDR hold scene-linear float, with premultiplied alpha (EXR) or none; the others display-referred codes.
bool isSceneLinear(ImageFormat format);

struct WriteSettings
{
    double exposure = 0.0; // stops; display-referred formats only, as the curves
    const ToneCurve* tone = findToneCurve("khronos_neutral");
    const TransferCurve* transfer = findTransferCurve("srgb");
    int bitsPerChannel = 8;                             // 16: PNG only, an Error (usage) otherwise
    int quality = 95;                                   // 1 to 100: JPEG and WebP; WebP at 100 is lossless
    std::map<std::string, std::string> attributes = {}; // header of EXR; the other formats have no place for them
};

/// `beauty` is scene-linear with 3 channels, or 4 with premultiplied alpha. PNG and WebP get straight alpha; JPEG and
/// HDR have none and get the picture over black. `extra` layers go into EXR; an Error (usage) where the format cannot
/// hold them.
std::vector<std::byte> encodePicture(ImageFormat format, const Image& beauty, std::span<const ImageLayer> extra,
                                     const WriteSettings& settings);

/// encodePicture to `path`, whole or not at all, or to standard output where it is "-".
void writePicture(const std::string& path, const Image& beauty, std::span<const ImageLayer> extra,
                  const WriteSettings& settings);

} // namespace torrance
