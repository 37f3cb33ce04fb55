#include "make_assets/hdr_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace torrance::assets {
namespace {

// Ward 1991: value = mantissa / 256 * 2^(exponent - 128). 1 = 128/256 * 2^1; 255.9 rounds up to the next exponent's
// 128.
TEST(HdrFile, BytesAreTheFormatsOwn)
{
    Image image(2, 1, 3);
    const float values[] = {1.0f, 0.5f, 0.0f, 255.9f, 1.0f, 0.0f};
    image.texels.assign(std::begin(values), std::end(values));
    const std::filesystem::path path = std::filesystem::temp_directory_path() / "torrance_hdr_file_test.hdr";
    writeHdr(path, image);
    std::ifstream file(path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    std::filesystem::remove(path);
    EXPECT_EQ(text, std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n") +
                        std::string("\x80\x40\x00\x81\x80\x01\x00\x89", 8));
}

} // namespace
} // namespace torrance::assets
