#include "plan/texel_facts.h"

#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <span>

namespace torrance {
namespace {

/// Every channel of every texel alike but for one texel, whose channels are given.
TextureImage withOne(int width, int height, std::size_t place, const std::array<int, 4>& odd, TexelFormat format)
{
    TextureImage image{"picture", width, height, format, {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(width) * static_cast<std::size_t>(height); ++i)
        for (const int channel : i == place ? odd : std::array{100, 100, 100, 100}) {
            const auto code = static_cast<std::uint16_t>(channel);
            const auto bytes = std::as_bytes(std::span(&code, 1));
            image.texels.insert(image.texels.end(), bytes.begin(),
                                bytes.begin() + (format == TexelFormat::rgba8 ? 1 : 2));
        }
    return image;
}

// A texel that differs is found wherever it stands, in each channel for itself, up and down.
TEST(TexelFacts, SeeEveryTexel)
{
    for (const TexelFormat format : {TexelFormat::rgba8, TexelFormat::rgba16}) {
        const int most = format == TexelFormat::rgba8 ? 255 : 65535;
        for (const auto& [width, height] : {std::pair(1, 1), {1, 2}, {3, 1}, {5, 1}, {7, 3}, {16, 16}})
            for (std::size_t place = 0; place < static_cast<std::size_t>(width * height); ++place) {
                const TexelFacts facts = texelFacts(withOne(width, height, place, {0, 99, 101, most}, format));
                const bool alone = width * height == 1;
                for (std::size_t c = 0; c < 4; ++c) {
                    const double odd = std::array{0, 99, 101, most}[c] / double(most), other = 100 / double(most);
                    EXPECT_EQ(facts.least[c], alone ? odd : std::min(odd, other)) << place;
                    EXPECT_EQ(facts.greatest[c], alone ? odd : std::max(odd, other)) << place;
                }
            }
    }
}

TEST(TexelFacts, SeeEveryPieceOfALargePicture)
{
    for (const std::size_t place : {0u, 1024u * 1024u / 4u - 1u, 1024u * 1024u / 4u, 700u * 700u - 1u}) {
        const TexelFacts facts = texelFacts(withOne(700, 700, place, {7, 100, 200, 100}, TexelFormat::rgba8));
        EXPECT_EQ(facts.least[0], 7 / 255.0) << place;
        EXPECT_EQ(facts.greatest[2], 200 / 255.0) << place;
        EXPECT_TRUE(facts.constant(1));
        EXPECT_FALSE(facts.constant(0));
    }
}

} // namespace
} // namespace torrance
