#include "files/deferred_images.h"

#include "files/texture_file.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace torrance {

DeferredImages::DeferredImages(std::vector<EncodedImage> images, std::vector<std::vector<std::byte>> kept)
    : encoded(std::move(images)), storage(std::move(kept)), asked(encoded.size()), left(encoded.size())
{
}

std::vector<std::size_t> DeferredImages::longestFirst() const
{
    std::vector<std::size_t> order(encoded.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return encoded[i].bytes.size(); });
    return order;
}

TextureImage DeferredImages::decode(std::size_t i)
{
    EncodedImage& image = encoded[i];
    assert(!asked[i]);
    asked[i] = 1;
    std::unique_ptr<DecodeScratch> scratch = takeScratch();
    TextureImage decoded = decodeTexture(image.bytes, image.name, image.file, *scratch);
    image.bytes = {};
    image.storage = {};
    giveBack(std::move(scratch));
    return decoded;
}

void DeferredImages::recycle(TextureImage image)
{
    const std::lock_guard lock(mutex);
    if (doneWith.size() < left) // more than there is use for is given up
        doneWith.push_back(std::move(image.texels));
}

std::unique_ptr<DecodeScratch> DeferredImages::takeScratch()
{
    const std::lock_guard lock(mutex);
    auto scratch = std::make_unique<DecodeScratch>();
    if (!idle.empty()) {
        scratch = std::move(idle.back());
        idle.pop_back();
    }
    if (!doneWith.empty()) {
        scratch->texels = std::move(doneWith.back());
        doneWith.pop_back();
    }
    return scratch;
}

void DeferredImages::giveBack(std::unique_ptr<DecodeScratch> scratch)
{
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(scratch));
    if (--left > 0)
        return;
    idle.clear();
    doneWith.clear();
    storage.clear();
}

} // namespace torrance
