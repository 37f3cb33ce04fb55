// writeLevels into memory that a test can look at.
#pragma once

#include "prepare/texture_levels.h"

#include <functional>
#include <gtest/gtest.h>
#include <vector>

namespace torrance::test {

/// What `write` puts into rows that lie `gap` bytes further apart than they must, taken together again: one vector per
/// level. A byte changed between or behind the rows fails the test.
inline std::vector<std::vector<std::byte>> levelBytes(int width, int height, int count, TexelStorage storage,
                                                      const std::function<void(std::span<const LevelMemory>)>& write,
                                                      std::size_t gap = 0)
{
    constexpr auto kUntouched = std::byte(0xa5);
    const auto rowBytes = [&](int level) {
        return static_cast<std::size_t>(std::max(1, width >> level)) * bytesPerTexel(storage);
    };
    const auto rows = [&](int level) { return static_cast<std::size_t>(std::max(1, height >> level)); };
    std::vector<std::vector<std::byte>> memory;
    std::vector<LevelMemory> levels;
    for (int level = 0; level < count; ++level) {
        memory.emplace_back((rowBytes(level) + gap) * rows(level) + 16, kUntouched);
        levels.push_back({memory.back().data(), rowBytes(level) + gap});
    }
    write(levels);
    std::vector<std::vector<std::byte>> tight;
    for (int level = 0; level < count; ++level) {
        tight.emplace_back();
        const auto& from = memory[static_cast<std::size_t>(level)];
        for (std::size_t i = 0; i < from.size(); ++i)
            if (i < (rowBytes(level) + gap) * rows(level) && i % (rowBytes(level) + gap) < rowBytes(level))
                tight.back().push_back(from[i]);
            else
                EXPECT_EQ(from[i], kUntouched) << "level " << level << ", byte " << i;
    }
    return tight;
}

inline std::vector<std::vector<std::byte>> levelBytes(const TextureImage& image, const MipRule& rule,
                                                      std::size_t gap = 0)
{
    return levelBytes(
        image.width, image.height, mipCount(image.width, image.height), storageOf(image.format, rule),
        [&](std::span<const LevelMemory> levels) { writeLevels(image, rule, levels); }, gap);
}

} // namespace torrance::test
