#include "make_assets/png_file.h"

#include "core/atomic_write.h"
#include "core/error.h"

#include <png.h>

namespace torrance::assets {

void writePng(const std::filesystem::path& path, const Picture& picture)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = picture.channels == 1 ? PNG_FORMAT_GRAY : picture.channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
    image.flags = PNG_IMAGE_FLAG_FAST; // built, not sent: size matters less than time
    writeFileThrough(path, [&](const std::filesystem::path& temporary) {
        if (!png_image_write_to_file(&image, temporary.c_str(), 0, picture.bytes.data(), 0, nullptr))
            throw writeError(path.string(), image.message, "");
    });
}

} // namespace torrance::assets
