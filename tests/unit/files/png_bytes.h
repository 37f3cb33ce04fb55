// PNG files built from the specification by the tests themselves: no libpng, no zlib (deflate's stored blocks).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace torrance::test {

struct PngSpec
{
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    int bitDepth = 8;
    int colorType = 6;                                            // 0 grey, 2 RGB, 3 palette, 4 grey + alpha, 6 RGBA
    int interlace = 0;                                            // 1: Adam7
    std::vector<std::uint8_t> scanlines;                          // each line preceded by its filter byte
    std::vector<std::pair<std::string, std::string>> chunks = {}; // between IHDR and IDAT
};

inline void appendBigEndian(std::string& bytes, std::uint32_t value)
{
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<char>(value >> shift));
}

// PNG specification, annex D, bit by bit.
inline std::uint32_t crc32(std::string_view bytes)
{
    std::uint32_t crc = 0xffffffffu;
    for (const char c : bytes) {
        crc ^= static_cast<std::uint8_t>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

inline std::string pngChunk(const std::string& name, const std::string& data)
{
    std::string bytes;
    appendBigEndian(bytes, static_cast<std::uint32_t>(data.size()));
    bytes += name + data;
    appendBigEndian(bytes, crc32(name + data));
    return bytes;
}

// RFC 1950 and 1951: header, one stored block of at most 65535 bytes, Adler-32.
inline std::string storedZlib(const std::vector<std::uint8_t>& data)
{
    const auto size = static_cast<std::uint16_t>(data.size());
    std::string bytes = {'\x78', '\x01', '\x01'};
    for (const std::uint16_t word : {size, static_cast<std::uint16_t>(~size)}) {
        bytes.push_back(static_cast<char>(word & 0xff));
        bytes.push_back(static_cast<char>(word >> 8));
    }
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t value : data) {
        bytes.push_back(static_cast<char>(value));
        a = (a + value) % 65521u;
        b = (b + a) % 65521u;
    }
    appendBigEndian(bytes, b << 16 | a);
    return bytes;
}

inline std::string pngBytes(const PngSpec& spec)
{
    std::string header;
    appendBigEndian(header, spec.width);
    appendBigEndian(header, spec.height);
    for (const int value : {spec.bitDepth, spec.colorType, 0, 0, spec.interlace})
        header.push_back(static_cast<char>(value));
    std::string bytes = "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header);
    for (const auto& [name, data] : spec.chunks)
        bytes += pngChunk(name, data);
    return bytes + pngChunk("IDAT", storedZlib(spec.scanlines)) + pngChunk("IEND", "");
}

} // namespace torrance::test
