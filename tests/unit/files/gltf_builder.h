// Small glTF documents made in memory, written to a folder of the test's own, and read back.
#pragma once

#include "core/error.h"
#include "files/scene_file.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>
#include <vector>

namespace torrance {

namespace gltf {
inline constexpr int kByte = 5120;
inline constexpr int kUnsignedByte = 5121;
inline constexpr int kShort = 5122;
inline constexpr int kUnsignedShort = 5123;
inline constexpr int kUnsignedInt = 5125;
inline constexpr int kFloat = 5126;
} // namespace gltf

/// A document and the one buffer behind it. Members of `json` can be changed to anything before it is written.
class GltfBuilder
{
public:
    nlohmann::json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}};
    std::vector<std::byte> binary;

    /// A buffer view over `values`, at a multiple of four bytes; its number.
    template <typename T>
    int addView(const std::vector<T>& values)
    {
        binary.resize((binary.size() + 3) / 4 * 4);
        const std::size_t offset = binary.size();
        binary.resize(offset + values.size() * sizeof(T));
        std::memcpy(binary.data() + offset, values.data(), values.size() * sizeof(T));
        return append("bufferViews",
                      {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(T)}});
    }

    /// A packed accessor over values of its own; its number.
    template <typename T>
    int addAccessor(const std::vector<T>& values, int componentType, const char* type, std::size_t count)
    {
        const int view = addView(values);
        return append("accessors",
                      {{"bufferView", view}, {"componentType", componentType}, {"type", type}, {"count", count}});
    }

    int addFloats(const std::vector<float>& values, const char* type)
    {
        return addAccessor(values, gltf::kFloat, type, values.size() / components(type));
    }

    int append(const char* array, nlohmann::json item)
    {
        json[array].push_back(std::move(item));
        return static_cast<int>(json[array].size()) - 1;
    }

    /// One node with one mesh of one primitive.
    GltfBuilder& setPrimitive(nlohmann::json primitive)
    {
        json["meshes"] = {{{"primitives", {std::move(primitive)}}}};
        json["nodes"] = {{{"mesh", 0}}};
        return *this;
    }

    /// A right-angled triangle in the plane z = 0, front to +Z, no normals.
    static GltfBuilder triangle()
    {
        GltfBuilder builder;
        const int position = builder.addFloats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
        builder.setPrimitive({{"attributes", {{"POSITION", position}}}});
        return builder;
    }

    nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }
    nlohmann::json& accessor(int index) { return json["accessors"][static_cast<std::size_t>(index)]; }
    nlohmann::json& view(int index) { return json["bufferViews"][static_cast<std::size_t>(index)]; }

    std::vector<std::byte> glb() const
    {
        nlohmann::json document = json;
        if (!document.contains("buffers") && !binary.empty())
            document["buffers"] = {{{"byteLength", binary.size()}}};
        return glbOf(document.dump(), binary);
    }

    static std::vector<std::byte> glbOf(std::string text, std::vector<std::byte> data)
    {
        text.resize((text.size() + 3) / 4 * 4, ' ');
        data.resize((data.size() + 3) / 4 * 4);
        std::vector<std::byte> bytes;
        const auto word = [&](std::size_t value) {
            for (int i = 0; i < 4; ++i)
                bytes.push_back(static_cast<std::byte>(value >> (8 * i)));
        };
        const auto* letters = reinterpret_cast<const std::byte*>(text.data());
        word(0x46546C67);
        word(2);
        word(12 + 8 + text.size() + (data.empty() ? 0 : 8 + data.size()));
        word(text.size());
        word(0x4E4F534A);
        bytes.insert(bytes.end(), letters, letters + text.size());
        if (!data.empty()) {
            word(data.size());
            word(0x004E4942);
            bytes.insert(bytes.end(), data.begin(), data.end());
        }
        return bytes;
    }

private:
    static std::size_t components(const std::string& type)
    {
        return type == "SCALAR" ? 1 : type == "MAT4" ? 16 : static_cast<std::size_t>(type.back() - '0');
    }
};

/// A folder that is removed when the test ends.
class TestFolder
{
public:
    TestFolder()
        : path(std::filesystem::path(testing::TempDir()) /
               ("torrance_gltf_" + std::to_string(::getpid()) + "_" + std::to_string(counter()++)))
    {
        std::filesystem::create_directories(path);
    }
    ~TestFolder() { std::filesystem::remove_all(path); }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    std::filesystem::path write(const std::string& name, const std::vector<std::byte>& bytes) const
    {
        std::filesystem::create_directories((path / name).parent_path());
        std::ofstream stream(path / name, std::ios::binary);
        stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return path / name;
    }
    std::filesystem::path write(const std::string& name, const std::string& text) const
    {
        const auto* first = reinterpret_cast<const std::byte*>(text.data());
        return write(name, std::vector<std::byte>(first, first + text.size()));
    }

    const std::filesystem::path path;

private:
    static int& counter()
    {
        static int number = 0;
        return number;
    }
};

inline LoadedScene load(const GltfBuilder& builder, const LoadOptions& options = {})
{
    const TestFolder folder;
    return loadScene(folder.write("model.glb", builder.glb()), options);
}

inline LoadedScene loadBytes(const std::vector<std::byte>& bytes)
{
    const TestFolder folder;
    return loadScene(folder.write("model.glb", bytes));
}

/// What loading says, checked to be an input error on one line that names the file; empty where it loads.
inline std::string errorOf(const std::filesystem::path& path, const LoadOptions& options = {})
{
    try {
        loadScene(path, options);
    } catch (const Error& error) {
        const std::string message = error.what();
        EXPECT_EQ(error.exitCode, ExitCode::input) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_TRUE(message.starts_with(path.string())) << message;
        EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
        return message;
    }
    return "";
}

inline std::string errorOf(const GltfBuilder& builder, const LoadOptions& options = {})
{
    const TestFolder folder;
    return errorOf(folder.write("model.glb", builder.glb()), options);
}

inline bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// How many warnings contain `part`.
inline int warningsAbout(const LoadedScene& loaded, const std::string& part)
{
    int count = 0;
    for (const std::string& warning : loaded.warnings)
        count += contains(warning, part) ? 1 : 0;
    return count;
}

} // namespace torrance
