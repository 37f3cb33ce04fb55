#include "files/encoded_image.h"

#include "core/cancelled.h"
#include "core/error.h"
#include "core/parallel.h"
#include "files/texture_file.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <numeric>

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

namespace {

// Numbers of the images, those first that take longest: workers that take the next one each end at about the same time.
std::vector<std::size_t> longestFirst(const std::vector<EncodedImage>& images)
{
    std::vector<std::size_t> order(images.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return images[i].bytes.size(); });
    return order;
}

// As many as there are workers at a time, each lent to one.
class ScratchPool
{
public:
    std::unique_ptr<DecodeScratch> take()
    {
        const std::lock_guard lock(mutex);
        if (idle.empty())
            return std::make_unique<DecodeScratch>();
        std::unique_ptr<DecodeScratch> scratch = std::move(idle.back());
        idle.pop_back();
        return scratch;
    }
    void giveBack(std::unique_ptr<DecodeScratch> scratch)
    {
        const std::lock_guard lock(mutex);
        idle.push_back(std::move(scratch));
    }

private:
    std::mutex mutex;
    std::vector<std::unique_ptr<DecodeScratch>> idle;
};

} // namespace

std::vector<TextureImage> decodeAll(const std::vector<EncodedImage>& encoded, const std::stop_token& stop)
{
    std::vector<TextureImage> images(encoded.size());
    std::vector<std::exception_ptr> failures(encoded.size());
    const std::vector<std::size_t> order = longestFirst(encoded);
    ScratchPool pool;
    parallelFor(order.size(), 1, [&](std::size_t place) {
        endWhereStopped(stop); // no failure of an image: the others are not begun
        const std::size_t i = order[place];
        try {
            std::unique_ptr<DecodeScratch> scratch = pool.take();
            images[i] = decodeTexture(encoded[i].bytes, encoded[i].name, encoded[i].file, *scratch);
            pool.giveBack(std::move(scratch));
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
