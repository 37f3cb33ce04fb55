#include "gpu/shader_compiler.h"

#include "core/error.h"

#include <algorithm>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <glslang/build_info.h>
#include <sstream>

namespace torrance::gpu {
namespace {

// glslang wants to be started once a process.
class GlslangProcess
{
public:
    GlslangProcess() { glslang::InitializeProcess(); }
    ~GlslangProcess() { glslang::FinalizeProcess(); }
};

class FileIncluder : public glslang::TShader::Includer
{
public:
    explicit FileIncluder(const ShaderSource& s) : source(s) {}

    IncludeResult* includeLocal(const char* name, const char*, std::size_t) override
    {
        const auto file = source.files.find(name);
        if (file == source.files.end())
            return nullptr;
        return new IncludeResult(file->first, file->second.data(), file->second.size(), nullptr);
    }
    void releaseInclude(IncludeResult* result) override { delete result; }

private:
    const ShaderSource& source;
};

EShLanguage stageOf(const std::string& entry)
{
    if (entry.ends_with(".vert"))
        return EShLangVertex;
    if (entry.ends_with(".frag"))
        return EShLangFragment;
    throw usageError(entry + ": not a shader", "entry points end in .vert or .frag");
}

// Only the first error: what follows is mostly its echo.
Error compileError(const std::string& entry, const char* log)
{
    std::istringstream lines(log);
    std::string line;
    while (std::getline(lines, line))
        if (line.starts_with("ERROR: "))
            return usageError(line.substr(7), "mend the shader");
    return usageError(entry + ": glslang failed: " + log, "mend the shader");
}

std::vector<ShaderBinding> reflect(glslang::TProgram& program)
{
    std::vector<ShaderBinding> bindings;
    program.buildReflection(EShReflectionSeparateBuffers | EShReflectionAllBlockVariables);
    for (int i = 0; i < program.getNumBufferBlocks(); ++i)
        bindings.push_back(
            {static_cast<std::uint32_t>(program.getBufferBlock(i).getBinding()), vk::DescriptorType::eStorageBuffer});
    for (int i = 0; i < program.getNumUniformBlocks(); ++i)
        bindings.push_back(
            {static_cast<std::uint32_t>(program.getUniformBlock(i).getBinding()), vk::DescriptorType::eUniformBuffer});
    for (int i = 0; i < program.getNumUniformVariables(); ++i) {
        const glslang::TObjectReflection& uniform = program.getUniform(i);
        if (uniform.getType()->getBasicType() == glslang::EbtSampler)
            bindings.push_back(
                {static_cast<std::uint32_t>(uniform.getBinding()), vk::DescriptorType::eCombinedImageSampler});
    }
    std::ranges::sort(bindings, {}, &ShaderBinding::binding);
    const auto again = std::ranges::unique(bindings); // declared twice: two views of one block
    bindings.erase(again.begin(), again.end());
    return bindings;
}

} // namespace

std::string shaderCompilerVersion()
{
    return std::to_string(GLSLANG_VERSION_MAJOR) + "." + std::to_string(GLSLANG_VERSION_MINOR) + "." +
           std::to_string(GLSLANG_VERSION_PATCH);
}

CompiledShader compileShader(const ShaderSource& source)
{
    static const GlslangProcess process;
    const EShLanguage stage = stageOf(source.entry);
    const std::string& text = source.files.at(source.entry);
    const char* string = text.c_str();
    const int length = static_cast<int>(text.size());
    const char* name = source.entry.c_str();

    glslang::TShader shader(stage);
    shader.setStringsWithLengthsAndNames(&string, &length, &name, 1);
    shader.setPreamble("#extension GL_GOOGLE_include_directive : require\n"
                       "#extension GL_GOOGLE_cpp_style_line_directive : require\n"
                       "#extension GL_EXT_scalar_block_layout : require\n");
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);

    constexpr int kVersion = 460;
    constexpr auto kMessages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    FileIncluder includer(source);
    if (!shader.parse(GetDefaultResources(), kVersion, false, kMessages, includer))
        throw compileError(source.entry, shader.getInfoLog());
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(kMessages))
        throw compileError(source.entry, program.getInfoLog());

    CompiledShader compiled = {.name = source.entry,
                               .stage = stage == EShLangVertex ? vk::ShaderStageFlagBits::eVertex
                                                               : vk::ShaderStageFlagBits::eFragment,
                               .words = {},
                               .bindings = reflect(program)};
    glslang::GlslangToSpv(*program.getIntermediate(stage), compiled.words);
    return compiled;
}

} // namespace torrance::gpu
