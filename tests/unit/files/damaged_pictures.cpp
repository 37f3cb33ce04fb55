// Pictures with bytes changed at random are decoded or refused; what this test is for shows under the sanitizers.
#include "core/error.h"
#include "core/log.h"
#include "files/image_read.h"
#include "files/image_write.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace torrance {
namespace {

// A picture with enough in it that every part of a decoder has work.
Image noise(int width, int height)
{
    Image image(width, height, 4);
    std::uint32_t state = 1;
    for (float& value : image.texels) {
        state = state * 1664525u + 1013904223u; // Numerical Recipes' generator
        value = static_cast<float>(state >> 8) / static_cast<float>(1 << 24);
    }
    return image;
}

class DamagedPictures : public ::testing::TestWithParam<ImageFormat>
{
};

TEST_P(DamagedPictures, AreDecodedOrRefused)
{
    const LogLevel level = logLevel();
    setLogLevel(LogLevel::quiet);
    std::string name = (std::filesystem::temp_directory_path() / "torrance-damaged-XXXXXX.png").string();
    close(mkstemps(name.data(), 4)); // told by content: the name keeps other libraries out
    const std::vector<std::byte> whole = encodePicture(GetParam(), noise(19, 11), {}, {});
    std::uint32_t state = 7;
    const auto random = [&](std::size_t below) {
        state = state * 1664525u + 1013904223u;
        return static_cast<std::size_t>(state >> 8) % below;
    };
    int refused = 0;
    constexpr int kRounds = 300;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<std::byte> damaged = whole;
        for (std::size_t i = 0; i <= random(4); ++i) {
            // The first bytes hold what sizes are taken from.
            const std::size_t place =
                random(2) == 0 ? random(std::min<std::size_t>(400, whole.size())) : random(whole.size());
            damaged[place] = static_cast<std::byte>(random(256));
        }
        std::ofstream(name, std::ios::binary)
            .write(reinterpret_cast<const char*>(damaged.data()), static_cast<std::streamsize>(damaged.size()));
        try {
            const ReadImage picture = readImage(name);
            EXPECT_EQ(picture.image.channels, static_cast<int>(picture.channelNames.size()));
        } catch (const Error& error) {
            EXPECT_EQ(error.exitCode, ExitCode::input) << error.what();
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            ++refused;
        }
    }
    EXPECT_GT(refused, 0) << "the damage does not reach the decoder";
    std::filesystem::remove(name);
    setLogLevel(level);
}

INSTANTIATE_TEST_SUITE_P(Formats, DamagedPictures,
                         ::testing::Values(ImageFormat::png, ImageFormat::jpeg, ImageFormat::webp, ImageFormat::exr,
                                           ImageFormat::hdr));

} // namespace
} // namespace torrance
