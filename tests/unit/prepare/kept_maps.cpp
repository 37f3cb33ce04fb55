#include "prepare/kept_maps.h"

#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace torrance {
namespace {

namespace fs = std::filesystem;

class KeptMaps : public testing::Test
{
protected:
    KeptMaps() : folder(fs::temp_directory_path() / ("torrance-maps-" + std::to_string(getpid()))) {}
    ~KeptMaps() override { fs::remove_all(folder); }

    static EnvironmentMaps smallMaps()
    {
        EnvironmentMaps maps = {.specular = {4, 2, {}}, .irradiance = {2, 1, {}}};
        float value = 0.0f;
        const auto fill = [&](CubeLevels& cube) {
            for (int level = 0; level < cube.levels; ++level) {
                const auto side = static_cast<std::size_t>(cube.size >> level);
                std::vector<float> texels(6 * side * side * 4);
                for (float& texel : texels)
                    texel = value += 0.5f;
                cube.data.push_back(texels);
            }
        };
        fill(maps.specular);
        fill(maps.irradiance);
        return maps;
    }

    std::optional<EnvironmentMaps> read() const
    {
        auto kept = DiskCache(folder, 1 << 20).open(key);
        return kept ? readMaps(std::move(*kept)) : std::nullopt;
    }

    void store(std::span<const std::span<const std::byte>> parts) const
    {
        DiskCache(folder, 1 << 20).store(key, parts);
    }

    fs::path folder;
    ContentHash key = hashText("maps");
};

TEST_F(KeptMaps, AreReadAsTheyWereKept)
{
    const EnvironmentMaps maps = smallMaps();
    store(KeptForm(maps).parts());
    const auto again = read();
    ASSERT_TRUE(again);
    EXPECT_EQ(again->specular.size, 4);
    EXPECT_EQ(again->specular.data, maps.specular.data);
    EXPECT_EQ(again->irradiance.data, maps.irradiance.data);
}

TEST_F(KeptMaps, DamagedAnywhereAreNone)
{
    const EnvironmentMaps maps = smallMaps();
    const KeptForm form(maps);
    store(form.parts());
    const fs::path file = folder / key.hex();
    const auto size = static_cast<std::streamoff>(fs::file_size(file));
    for (std::streamoff at = 0; at < size; at += 13) {
        std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
        stream.seekg(at);
        const int byte = stream.get();
        stream.seekp(at).put(static_cast<char>(byte ^ 0x40));
        stream.close();
        EXPECT_FALSE(read()) << "byte " << at;
        store(form.parts());
    }
    for (std::streamoff length = size - 1; length > 0; length -= 97) {
        fs::resize_file(file, static_cast<std::uintmax_t>(length));
        EXPECT_FALSE(read()) << length << " bytes";
    }
}

// Intact, but not ours: no memory is taken for what it claims to hold.
TEST_F(KeptMaps, OfAnImpossibleShapeAreNone)
{
    for (const KeptShape shape :
         {KeptShape{1u << 30, 1, 2, 0}, {4, 0, 2, 0}, {4, 30, 2, 0}, {4, 4, 2, 0}, {4, 2, 1u << 30, 0}, {4, 2, 2, 0}})
    {
        const std::span<const std::byte> part = std::as_bytes(std::span(&shape, 1));
        store(std::span(&part, 1));
        EXPECT_FALSE(read()) << shape.size << ", " << shape.levels << ", " << shape.irradianceSize;
    }
}

} // namespace
} // namespace torrance
