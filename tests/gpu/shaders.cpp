#include "gpu/shader_library.h"

#include "core/error.h"
#include "test_device.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace torrance {
namespace {

namespace fs = std::filesystem;

class ShaderTest : public testing::Test
{
protected:
    ShaderTest() : folder(fs::temp_directory_path() / ("torrance-shaders-" + std::to_string(getpid())))
    {
        fs::create_directories(folder / "cache");
    }
    ~ShaderTest() override { fs::remove_all(folder); }

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }

    fs::path folder;
};

TEST_F(ShaderTest, AnErrorNamesFileAndLineOfTheInclude)
{
    write("broken.glsl", "float f()\n{\n    return nonsense;\n}\n");
    write("main.frag", "#include \"broken.glsl\"\nlayout(location = 0) out vec4 c;\nvoid main() { c = vec4(f()); }\n");
    gpu::ShaderLibrary library(folder, {});
    try {
        library.get("main.frag", "");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("broken.glsl:3"), std::string::npos) << error.what();
    }
}

TEST_F(ShaderTest, AMissingIncludeIsSaid)
{
    write("main.frag", "#include \"absent.glsl\"\nvoid main() {}\n");
    gpu::ShaderLibrary library(folder, {});
    EXPECT_THROW(library.get("main.frag", ""), Error);
}

TEST_F(ShaderTest, ReflectionNamesTheBindingsThatAreUsed)
{
    write("main.frag", "layout(set = 0, binding = 3) uniform sampler2D t;\n"
                       "layout(set = 0, binding = 5) uniform sampler2D unused;\n"
                       "layout(set = 0, binding = 1, scalar) readonly buffer B { vec3 v[]; };\n"
                       "layout(location = 0) out vec4 c;\nvoid main() { c = texture(t, v[0].xy); }\n");
    gpu::ShaderLibrary library(folder, {});
    const gpu::CompiledShader shader = library.get("main.frag", "");
    const std::vector<gpu::ShaderBinding> expected = {{1, vk::DescriptorType::eStorageBuffer},
                                                      {3, vk::DescriptorType::eCombinedImageSampler}};
    EXPECT_EQ(shader.bindings, expected);
}

TEST_F(ShaderTest, TheCacheFollowsEveryTextThatIsIncluded)
{
    write("part.glsl", "const float k = 1.0;\n");
    write("main.frag", "#include \"selected.glsl\"\n#include \"part.glsl\"\nlayout(location = 0) out vec4 c;\nvoid "
                       "main() { c = vec4(k * SCALE); }\n");
    const auto compiled = [&](const std::string& selected) {
        gpu::ShaderLibrary library(folder, folder / "cache");
        const auto words = library.get("main.frag", selected).words;
        return std::pair(library.compiledCount(), words);
    };
    const auto first = compiled("#define SCALE 1.0\n");
    EXPECT_EQ(first.first, 1u);
    EXPECT_EQ(compiled("#define SCALE 1.0\n"), std::pair(std::size_t(0), first.second))
        << "the second time it comes from the cache, unchanged";
    EXPECT_EQ(compiled("#define SCALE 2.0\n").first, 1u) << "another selection is another shader";
    write("part.glsl", "const float k = 3.0;\n");
    EXPECT_EQ(compiled("#define SCALE 1.0\n").first, 1u) << "so is another text of an included file";
}

} // namespace
} // namespace torrance
