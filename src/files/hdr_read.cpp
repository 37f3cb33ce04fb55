#include "files/hdr_file.h"

#include "core/error.h"
#include "core/huge_pages.h"
#include "files/image_limits.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <vector>

namespace torrance {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

// No header that a program writes comes near it; a file without an end of its header must not be searched for ever.
constexpr std::size_t kMaxHeaderBytes = 1 << 16;
// Scanlines outside this range cannot be coded in the new way.
constexpr std::size_t kMinRunLine = 8, kMaxRunLine = 32767;

struct Header
{
    std::array<double, 3> gain = {1.0, 1.0, 1.0}; // what the stored values were multiplied with
    bool columns = false;                         // scanlines run along Y
    bool fromBottom = false;                      // +Y
    bool fromRight = false;                       // -X
    int width = 0;
    int height = 0;
};

struct Reader
{
    std::string_view bytes;
    const std::string& file;
    std::size_t next = 0;

    [[noreturn]] void fail(const std::string& problem) const
    {
        throw inputError(file, "", problem, "export the picture again");
    }
    std::uint8_t take()
    {
        if (next >= bytes.size())
            fail("the HDR file ends too early");
        return static_cast<std::uint8_t>(bytes[next++]);
    }
    std::string_view take(std::size_t count)
    {
        if (count > bytes.size() - next)
            fail("the HDR file ends too early");
        next += count;
        return bytes.substr(next - count, count);
    }
    std::string_view line()
    {
        const std::size_t end = bytes.substr(0, kMaxHeaderBytes).find('\n', next);
        if (end == std::string_view::npos)
            fail("the HDR file's header has no end");
        std::string_view text = bytes.substr(next, end - next);
        next = end + 1;
        if (!text.empty() && text.back() == '\r')
            text.remove_suffix(1);
        return text;
    }
};

template <typename Number>
std::optional<Number> takeNumber(std::string_view& text)
{
    while (!text.empty() && text.front() == ' ')
        text.remove_prefix(1);
    Number value = {};
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc())
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

void readGain(const Reader& reader, std::string_view text, bool perChannel, Header& header)
{
    for (std::size_t channel = 0; channel < 3; ++channel) {
        std::string_view rest = text;
        const auto factor = takeNumber<double>(perChannel ? text : rest);
        if (!factor || !std::isfinite(*factor) || *factor <= 0.0)
            reader.fail("the HDR file's EXPOSURE or COLORCORR is no positive number");
        header.gain[channel] *= *factor;
    }
}

void readVariable(const Reader& reader, std::string_view line, Header& header)
{
    const auto valueOf = [&](std::string_view name) -> std::optional<std::string_view> {
        return line.starts_with(name) ? std::optional(line.substr(name.size())) : std::nullopt;
    };
    if (const auto format = valueOf("FORMAT="); format && format->find("32-bit_rle_rgbe") == std::string_view::npos)
        reader.fail("the HDR file stores " + std::string(*format) + ", and only 32-bit_rle_rgbe is read");
    if (const auto exposure = valueOf("EXPOSURE="))
        readGain(reader, *exposure, false, header);
    if (const auto correction = valueOf("COLORCORR="))
        readGain(reader, *correction, true, header);
}

struct Axis
{
    char name;
    bool negative;
    int length;
};

Axis readAxis(const Reader& reader, std::string_view& line)
{
    while (!line.empty() && line.front() == ' ')
        line.remove_prefix(1);
    if (line.size() < 3 || (line[0] != '+' && line[0] != '-') || (line[1] != 'X' && line[1] != 'Y'))
        reader.fail("the HDR file has no line like -Y 512 +X 1024");
    Axis axis{.name = line[1], .negative = line[0] == '-', .length = 0};
    line.remove_prefix(2);
    const auto length = takeNumber<int>(line);
    if (!length)
        reader.fail("the HDR file's size is no number");
    axis.length = *length;
    return axis;
}

void readResolution(const Reader& reader, std::string_view line, Header& header)
{
    const Axis lines = readAxis(reader, line), along = readAxis(reader, line);
    if (lines.name == along.name)
        reader.fail("the HDR file names one axis twice");
    header.columns = lines.name == 'X';
    const Axis &x = header.columns ? lines : along, &y = header.columns ? along : lines;
    header.width = x.length;
    header.height = y.length;
    header.fromRight = x.negative;
    header.fromBottom = !y.negative;
    checkImageSize(header.width, header.height, 3, reader.file);
}

Header readHeader(Reader& reader)
{
    Header header;
    for (std::string_view line = reader.line(); !line.empty(); line = reader.line())
        readVariable(reader, line, header);
    readResolution(reader, reader.line(), header);
    return header;
}

// A scanline, channel after channel.
struct Line
{
    std::size_t length;
    std::array<std::vector<std::uint8_t>, 4> channels;

    explicit Line(std::size_t texels) : length(texels)
    {
        for (auto& channel : channels)
            channel.resize(texels);
    }
    void set(std::size_t x, const Rgbe& texel)
    {
        for (std::size_t channel = 0; channel < 4; ++channel)
            channels[channel][x] = texel[channel];
    }
};

// Each of the four bytes of all texels in turn: a count above 128 repeats one byte, below it that many follow.
void readNewRuns(Reader& reader, Line& line)
{
    for (std::vector<std::uint8_t>& channel : line.channels)
        for (std::size_t x = 0; x < channel.size();) {
            const std::size_t code = reader.take();
            const std::size_t count = code > 128 ? code - 128 : code;
            if (count == 0 || count > channel.size() - x)
                reader.fail("the HDR file has a run past the end of a line");
            if (code > 128)
                std::memset(channel.data() + x, reader.take(), count);
            else
                std::memcpy(channel.data() + x, reader.take(count).data(), count);
            x += count;
        }
}

// Texels as they are; 1 1 1 n repeats the last one n times, and further such texels in a row count for 256, 65536, ...
// times.
void readOldRuns(Reader& reader, Line& line, const Rgbe& first)
{
    std::size_t x = 0;
    Rgbe last = {};
    std::size_t unit = 1;
    for (Rgbe texel = first;;) {
        if (texel[0] == 1 && texel[1] == 1 && texel[2] == 1) {
            const std::size_t count = texel[3] * unit;
            if (x == 0 || count > line.length - x)
                reader.fail("the HDR file has a run past the end of a line");
            for (std::size_t i = 0; i < count; ++i, ++x)
                line.set(x, last);
            unit *= 256;
            if (unit > kMaxImageSide * std::size_t(256))
                reader.fail("the HDR file has an endless run");
        } else {
            last = texel;
            line.set(x++, texel);
            unit = 1;
        }
        if (x == line.length)
            return;
        for (std::uint8_t& value : texel)
            value = reader.take();
    }
}

void readLine(Reader& reader, Line& line)
{
    Rgbe first;
    for (std::uint8_t& value : first)
        value = reader.take();
    const bool marked = first[0] == 2 && first[1] == 2 && (first[2] & 0x80) == 0;
    if (!marked || line.length < kMinRunLine || line.length > kMaxRunLine)
        return readOldRuns(reader, line, first);
    if ((std::size_t(first[2]) << 8 | first[3]) != line.length)
        reader.fail("the HDR file has a line of another length");
    readNewRuns(reader, line);
}

// What a mantissa of 1 stands for, by the exponent's byte: its bias is 128, and the mantissa has 8 bits below the
// point; 0 stands for black.
const std::array<double, 256>& units()
{
    static const std::array<double, 256> table = [] {
        std::array<double, 256> units = {};
        for (int exponent = 1; exponent < 256; ++exponent)
            units[static_cast<std::size_t>(exponent)] = std::ldexp(1.0, exponent - 136);
        return units;
    }();
    return table;
}

// `step` texels apart.
void storeTexels(const Line& line, const std::array<double, 3>& gain, float* texel, std::ptrdiff_t step)
{
    const std::array<double, 256>& unitOf = units();
    const bool plain = gain == std::array{1.0, 1.0, 1.0}; // division by 1 changes nothing, and takes its time
    for (std::size_t i = 0; i < line.length; ++i, texel += 3 * step) {
        const double unit = unitOf[line.channels[3][i]];
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double value = line.channels[channel][i] * unit;
            texel[channel] = static_cast<float>(plain ? value : value / gain[channel]);
        }
    }
}

void storeLine(const Line& line, int number, const Header& header, Image& image)
{
    const int x = header.columns ? number : 0, y = header.columns ? 0 : number;
    float* first = image.at(header.fromRight ? header.width - 1 - x : x, header.fromBottom ? header.height - 1 - y : y);
    const std::ptrdiff_t alongX = header.fromRight ? -1 : 1, alongY = header.fromBottom ? -header.width : header.width;
    storeTexels(line, header.gain, first, header.columns ? alongY : alongX);
}

} // namespace

bool isHdr(std::span<const std::byte> bytes)
{
    return bytes.size() > 2 && bytes[0] == std::byte('#') && bytes[1] == std::byte('?');
}

Image decodeHdr(std::span<const std::byte> bytes, const std::string& file)
{
    Reader reader{.bytes = {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, .file = file};
    const Header header = readHeader(reader);
    const int lines = header.columns ? header.width : header.height;
    // The least that a line takes is one texel and its repetition: what is shorter need not be given memory.
    if (bytes.size() - reader.next < std::size_t(4) * static_cast<std::size_t>(lines))
        reader.fail("the HDR file ends too early");
    Image image;
    image.width = header.width, image.height = header.height, image.channels = 3;
    resizeLarge(image.texels,
                std::size_t(3) * static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height));
    Line line(static_cast<std::size_t>(header.columns ? header.height : header.width));
    for (int number = 0; number < lines; ++number) {
        readLine(reader, line);
        storeLine(line, number, header, image);
    }
    return image;
}

} // namespace torrance
