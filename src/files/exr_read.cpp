#include "files/exr_file.h"

#include "core/error.h"
#include "files/image_limits.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cstring>

namespace torrance {
namespace {

using Window = Imath::Box2i;

class MemoryInput : public Imf::IStream
{
public:
    MemoryInput(std::span<const std::byte> held, const std::string& file) : IStream(file.c_str()), bytes(held) {}

    bool read(char to[], int count) override
    {
        if (count < 0 || static_cast<std::size_t>(count) > bytes.size() - std::min<std::uint64_t>(next, bytes.size()))
            throw std::runtime_error("the file ends too early");
        std::memcpy(to, bytes.data() + next, static_cast<std::size_t>(count));
        next += static_cast<std::uint64_t>(count);
        return next < bytes.size();
    }
    std::uint64_t tellg() override { return next; }
    void seekg(std::uint64_t position) override { next = position; }

private:
    std::span<const std::byte> bytes;
    std::uint64_t next = 0;
};

long long widthOf(const Window& window)
{
    return static_cast<long long>(window.max.x) - window.min.x + 1;
}

long long heightOf(const Window& window)
{
    return static_cast<long long>(window.max.y) - window.min.y + 1;
}

std::vector<std::string> channelNamesOf(const Imf::Header& header, const std::string& file)
{
    std::vector<std::string> names;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
            throw inputError(file, channel.name(), "the channel is subsampled", "store it at full size");
        names.emplace_back(channel.name());
    }
    return names;
}

Image readWindow(Imf::InputPart& part, const Window& window, const std::vector<std::string>& names)
{
    Image image(static_cast<int>(widthOf(window)), static_cast<int>(heightOf(window)), static_cast<int>(names.size()));
    const std::size_t pixelBytes = names.size() * sizeof(float);
    const std::size_t rowBytes = pixelBytes * static_cast<std::size_t>(image.width);
    Imf::FrameBuffer frame;
    for (std::size_t channel = 0; channel < names.size(); ++channel)
        frame.insert(names[channel],
                     Imf::Slice::Make(Imf::FLOAT, image.texels.data() + channel, window, pixelBytes, rowBytes));
    part.setFrameBuffer(frame);
    part.readPixels(window.min.y, window.max.y);
    return image;
}

Image moved(const Image& data, const Window& from, const Window& to)
{
    Image image(static_cast<int>(widthOf(to)), static_cast<int>(heightOf(to)), data.channels);
    const Window shared(Imath::V2i(std::max(from.min.x, to.min.x), std::max(from.min.y, to.min.y)),
                        Imath::V2i(std::min(from.max.x, to.max.x), std::min(from.max.y, to.max.y)));
    if (shared.isEmpty())
        return image;
    for (int y = shared.min.y; y <= shared.max.y; ++y)
        std::copy_n(data.at(shared.min.x - from.min.x, y - from.min.y), widthOf(shared) * data.channels,
                    image.at(shared.min.x - to.min.x, y - to.min.y));
    return image;
}

// Deflate, and run-length coding all the more, cannot shrink further than this (RFC 1951: 258 bytes from two bits). A
// file that claims more than its length can hold is refused before memory is taken for it; wavelets and cosines are not
// judged.
constexpr long long kMaxDeflateRatio = 1040;

bool canHold(std::size_t bytes, long long values, Imf::Compression compression)
{
    const bool deflates = compression == Imf::NO_COMPRESSION || compression == Imf::RLE_COMPRESSION ||
                          compression == Imf::ZIPS_COMPRESSION || compression == Imf::ZIP_COMPRESSION;
    constexpr long long kLeastValueBytes = 2; // half
    return !deflates || values * kLeastValueBytes / kMaxDeflateRatio <= static_cast<long long>(bytes);
}

ExrImage readFirstPart(std::span<const std::byte> bytes, const std::string& file)
{
    MemoryInput stream(bytes, file);
    Imf::MultiPartInputFile input(stream);
    const Imf::Header& header = input.header(0);
    if (header.hasType() && Imf::isDeepData(header.type()))
        throw inputError(file, "", "the EXR file holds deep data", "flatten it");
    if (!input.partComplete(0))
        throw inputError(file, "", "the EXR file is not complete", "export the picture again");
    const Window data = header.dataWindow(), display = header.displayWindow();
    ExrImage result{.image = {}, .channelNames = channelNamesOf(header, file), .parts = input.parts()};
    const auto channels = static_cast<long long>(result.channelNames.size());
    checkImageSize(widthOf(data), heightOf(data), channels, file);
    checkImageSize(widthOf(display), heightOf(display), channels, file);
    if (!canHold(bytes.size(), widthOf(data) * heightOf(data) * channels, header.compression()))
        throw inputError(file, "", "the EXR file ends too early", "export the picture again");
    Imf::InputPart part(input, 0);
    result.image = readWindow(part, data, result.channelNames);
    if (data != display)
        result.image = moved(result.image, data, display);
    return result;
}

} // namespace

bool isExr(std::span<const std::byte> bytes)
{
    constexpr std::byte kMagic[] = {std::byte(0x76), std::byte(0x2f), std::byte(0x31), std::byte(0x01)};
    return bytes.size() > 4 && std::equal(std::begin(kMagic), std::end(kMagic), bytes.begin());
}

namespace {

/// The library's exceptions as Errors that name the file.
template <typename Read>
auto readGuarded(const std::string& file, const Read& read)
{
    try {
        return read();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw inputError(file, "", std::string("the EXR file is corrupt: ") + error.what(), "export the picture again");
    }
}

} // namespace

ExrImage decodeExr(std::span<const std::byte> bytes, const std::string& file)
{
    return readGuarded(file, [&] { return readFirstPart(bytes, file); });
}

std::optional<std::string> exrAttribute(std::span<const std::byte> bytes, const std::string& file,
                                        const std::string& name)
{
    return readGuarded(file, [&]() -> std::optional<std::string> {
        MemoryInput stream(bytes, file);
        Imf::MultiPartInputFile input(stream);
        const auto* attribute = input.header(0).findTypedAttribute<Imf::StringAttribute>(name);
        return attribute ? std::optional(attribute->value()) : std::nullopt;
    });
}

} // namespace torrance
