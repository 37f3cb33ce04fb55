#include "files/exr_file.h"

#include "core/error.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cassert>

namespace torrance {
namespace {

class MemoryOutput : public Imf::OStream
{
public:
    MemoryOutput() : OStream("memory") {}

    void write(const char from[], int count) override
    {
        const auto view = std::as_bytes(std::span(from, static_cast<std::size_t>(count)));
        if (next + view.size() > bytes.size())
            bytes.resize(next + view.size());
        std::copy(view.begin(), view.end(), bytes.begin() + static_cast<std::ptrdiff_t>(next));
        next += view.size();
    }
    std::uint64_t tellp() override { return next; }
    void seekp(std::uint64_t position) override { next = position; }

    std::vector<std::byte> bytes;

private:
    std::uint64_t next = 0;
};

std::string channelName(const ImageLayer& layer, std::size_t channel)
{
    return layer.name.empty() ? layer.channels[channel] : layer.name + "." + layer.channels[channel];
}

// The frame buffer's pointers are not written through: the library's type serves reading, too.
char* firstValue(const ImageLayer& layer, std::size_t channel)
{
    return const_cast<char*>(reinterpret_cast<const char*>(layer.image.texels.data() + channel));
}

} // namespace

std::vector<std::byte> encodeExr(std::span<const ImageLayer> layers,
                                 const std::map<std::string, std::string>& attributes)
{
    assert(!layers.empty());
    const int width = layers[0].image.width, height = layers[0].image.height;
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, text] : attributes)
        header.insert(name, Imf::StringAttribute(text));
    Imf::FrameBuffer frame;
    for (const ImageLayer& layer : layers) {
        assert(layer.image.width == width && layer.image.height == height);
        assert(static_cast<std::size_t>(layer.image.channels) == layer.channels.size());
        const std::size_t pixelBytes = layer.channels.size() * sizeof(float);
        for (std::size_t channel = 0; channel < layer.channels.size(); ++channel) {
            header.channels().insert(channelName(layer, channel), Imf::Channel(Imf::FLOAT));
            frame.insert(channelName(layer, channel), Imf::Slice(Imf::FLOAT, firstValue(layer, channel), pixelBytes,
                                                                 pixelBytes * static_cast<std::size_t>(width)));
        }
    }
    MemoryOutput stream;
    {
        Imf::OutputFile file(stream, header); // its destructor writes the line table
        file.setFrameBuffer(frame);
        file.writePixels(height);
    }
    return std::move(stream.bytes);
}

} // namespace torrance
