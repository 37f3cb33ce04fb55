#include "files/encoded_image.h"

#include "core/error.h"
#include "core/parallel.h"
#include "files/deferred_images.h"
#include "files/texture_file.h"

#include <exception>

namespace torrance {

void checkTotalSize(const std::vector<EncodedImage>& images, std::uint64_t maxTexelBytes)
{
    // Eight bytes a texel, as 16-bit images take: what is refused does not depend on a header's finer points.
    constexpr std::uint64_t kBytesPerTexel = 8;
    std::uint64_t total = 0;
    for (const EncodedImage& image : images) {
        const auto size = textureSize(image.bytes);
        if (!size)
            continue; // decoding says what is wrong with it
        total += static_cast<std::uint64_t>(size->width) * static_cast<std::uint64_t>(size->height) * kBytesPerTexel;
        if (total > maxTexelBytes)
            throw inputError(image.file, image.name,
                             "brings the images of the file to more than " + std::to_string(maxTexelBytes) +
                                 " bytes of texels",
                             "use smaller images");
    }
}

std::vector<TextureImage> decodeAll(std::vector<EncodedImage> encoded)
{
    DeferredImages deferred(std::move(encoded), {});
    std::vector<TextureImage> images(deferred.count());
    std::vector<std::exception_ptr> failures(images.size());
    const std::vector<std::size_t> order = deferred.longestFirst();
    parallelFor(order.size(), 1, [&](std::size_t place) {
        const std::size_t i = order[place];
        try {
            images[i] = deferred.decode(i);
        } catch (...) {
            failures[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& failure : failures)
        if (failure)
            std::rethrow_exception(failure);
    return images;
}

} // namespace torrance
