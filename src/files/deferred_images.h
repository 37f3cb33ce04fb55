// Pictures of a scene that are decoded when somebody asks for them, so that texels of one may be gone before those of
// the next are made.
#pragma once

#include "files/decode_scratch.h"
#include "files/encoded_image.h"

#include <memory>
#include <mutex>
#include <vector>

namespace torrance {

class DeferredImages
{
public:
    /// `kept` are bytes that the images look into.
    DeferredImages(std::vector<EncodedImage> images, std::vector<std::vector<std::byte>> kept);

    std::size_t count() const { return encoded.size(); }

    /// Numbers of the images, those first that take longest to decode: several threads that take the next one each end
    /// at about the same time.
    std::vector<std::size_t> longestFirst() const;

    /// The image with its texels: once each, from any thread, in any order. Throws as decodeTexture does.
    TextureImage decode(std::size_t i);

    /// Gives the memory of an image that is done with to one that is still to be decoded.
    void recycle(TextureImage image);

private:
    std::unique_ptr<DecodeScratch> takeScratch();
    void giveBack(std::unique_ptr<DecodeScratch> scratch);

    std::vector<EncodedImage> encoded;
    std::vector<std::vector<std::byte>> storage;
    std::vector<std::uint8_t> asked; // by image: flags, each written by one thread
    std::mutex mutex;                // of what follows
    std::size_t left;                // to be decoded
    std::vector<std::unique_ptr<DecodeScratch>> idle;
    std::vector<std::vector<std::byte>> doneWith; // texels
};

} // namespace torrance
