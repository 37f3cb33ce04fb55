#include "gpu/retype_shader.h"

#include "gpu/glsl_tokens.h"

#include <gtest/gtest.h>

namespace torrance::gpu {
namespace {

TEST(GlslTokens, PutTogetherAreTheText)
{
    const std::string text = "#define X \"a 1.0\"\n/* float 1.0 */ float a = b.x*1.5e-3f; // vec3\nuint u = 0x1eu;";
    std::string whole;
    for (const GlslToken& token : glslTokens(text))
        whole += token.text;
    EXPECT_EQ(whole, text);
}

TEST(GlslTokens, KnowFloatsFromIntegers)
{
    for (const char* number : {"1.0", ".5", "1.", "1e5", "1e-5", "2.5f", "3F"})
        EXPECT_TRUE(isFloatLiteral(number)) << number;
    for (const char* number : {"1", "7u", "0x1e5", "0xFF", "0X3f"})
        EXPECT_FALSE(isFloatLiteral(number)) << number;
}

TEST(RetypedShader, ChangesTypesAndLiteralsAndNothingElse)
{
    const std::string text = "// a float of 1.0\nconst float k = 1e-30f;\n"
                             "vec3 f(vec2 floats, mat3 m) { return vec3(.5 * floats.x, a1.x, 2) * k - 1.5e+3; }\n";
    EXPECT_EQ(retyped(text, Precision::fp64),
              "// a float of 1.0\nconst double k = 1e-30lf;\n"
              "dvec3 f(dvec2 floats, dmat3 m) { return dvec3(.5lf * floats.x, a1.x, 2) * k - 1.5e+3lf; }\n");
    EXPECT_EQ(retyped(text, Precision::fp16),
              "// a float of 1.0\nconst float16_t k = 1e-30hf;\n"
              "f16vec3 f(f16vec2 floats, f16mat3 m) { return f16vec3(.5hf * floats.x, a1.x, 2) * k - 1.5e+3hf; }\n");
    EXPECT_EQ(retyped(text, Precision::fp32), text);
}

TEST(RetypedShader, ReachesDefinitionsInDirectivesAndKeepsNamesInQuotes)
{
    EXPECT_EQ(retyped("#include \"float.glsl\"\n#define ONE vec3(1.0)\n", Precision::fp64),
              "#include \"float.glsl\"\n#define ONE dvec3(1.0lf)\n");
}

ShaderSource source()
{
    return {.entry = "main.frag",
            .files = {{"main.frag", "#include \"part.glsl\"\nfloat kept = 1.0;\nvoid main() { USED; }\n"},
                      {"part.glsl", "#define USED f(1.0)\n"
                                    "float g(float x) { if (x > 0.0) { return x; } return 2.0; }\n"
                                    "float f(float x)\n{\n    return g(x);\n}\n"
                                    "float idle(float x) { return exp(x) + idler(x); }\n"
                                    "float idler(float x) { return pow(x, x); }\n"}}};
}

TEST(RetypedShader, LeavesOutFunctionsThatNothingCalls)
{
    const ShaderSource changed = retyped(source(), Precision::fp64, {"main.frag"});
    EXPECT_EQ(changed.files.at("main.frag"), source().files.at("main.frag"));
    EXPECT_EQ(changed.files.at("part.glsl"), "#define USED f(1.0lf)\n"
                                             "double g(double x) { if (x > 0.0lf) { return x; } return 2.0lf; }\n"
                                             "double f(double x)\n{\n    return g(x);\n}\n"
                                             "\n\n");
    EXPECT_TRUE(unavailableFunctions(changed, Precision::fp64).empty());
}

TEST(RetypedShader, NamesTheFunctionsThatThePrecisionLacks)
{
    ShaderSource calls = source();
    calls.files["part.glsl"] += "#define MORE idle(1.0) + uintBitsToFloat(1u)\n";
    const auto named = [&](Precision precision) {
        return unavailableFunctions(retyped(calls, precision, {"main.frag"}), precision);
    };
    EXPECT_EQ(named(Precision::fp64), (std::vector<std::string>{"exp", "pow", "uintBitsToFloat"}));
    EXPECT_EQ(named(Precision::fp16), std::vector<std::string>{"uintBitsToFloat"});
    EXPECT_TRUE(named(Precision::fp32).empty());
}

} // namespace
} // namespace torrance::gpu
