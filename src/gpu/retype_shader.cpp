#include "gpu/retype_shader.h"

#include "gpu/glsl_tokens.h"

#include <algorithm>
#include <array>
#include <map>

namespace torrance::gpu {
namespace {

std::string scalarType(Precision precision)
{
    return precision == Precision::fp64 ? "double" : "float16_t";
}

// `vec3` to `dvec3` or `f16vec3`, `mat3x4` to `dmat3x4`.
std::string compositeType(std::string_view word, Precision precision)
{
    return (precision == Precision::fp64 ? "d" : "f16") + std::string(word);
}

bool isComposite(std::string_view word)
{
    constexpr std::array<std::string_view, 6> kNames = {"vec2", "vec3", "vec4", "mat2", "mat3", "mat4"};
    return std::ranges::find(kNames, word) != kNames.end();
}

bool isScalarOrCompositeType(std::string_view word)
{
    constexpr std::array<std::string_view, 5> kOthers = {"float", "int", "uint", "bool", "void"};
    return isComposite(word) || std::ranges::find(kOthers, word) != kOthers.end();
}

std::string literal(std::string_view number, Precision precision)
{
    if (!isFloatLiteral(number))
        return std::string(number);
    if (number.back() == 'f' || number.back() == 'F')
        number.remove_suffix(1);
    return std::string(number) + (precision == Precision::fp64 ? "lf" : "hf");
}

std::string retypedToken(const GlslToken& token, Precision precision)
{
    if (token.kind == GlslToken::Kind::number)
        return literal(token.text, precision);
    if (token.kind == GlslToken::Kind::word && token.text == "float")
        return scalarType(precision);
    if (token.kind == GlslToken::Kind::word && isComposite(token.text))
        return compositeType(token.text, precision);
    return std::string(token.text);
}

// Tokens [first, last) of a file: from the type that a function returns to its closing brace.
struct Function
{
    std::string name;
    std::size_t first = 0, last = 0;
};

class FunctionFinder
{
public:
    explicit FunctionFinder(const std::vector<GlslToken>& t) : tokens(t) {}

    std::vector<Function> find() const
    {
        std::vector<Function> functions;
        for (std::size_t i = 0; i < tokens.size(); ++i)
            if (const Function function = definedAt(i); function.last > 0) {
                functions.push_back(function);
                i = function.last - 1;
            }
        return functions;
    }

private:
    // `type name ( ... ) {`; last = 0 where there is none.
    Function definedAt(std::size_t type) const
    {
        const std::size_t name = next(type), open = next(name), end = tokens.size();
        if (open >= end || tokens[type].kind != GlslToken::Kind::word || !isScalarOrCompositeType(tokens[type].text) ||
            tokens[name].kind != GlslToken::Kind::word || tokens[open].text != "(")
            return {};
        const std::size_t body = next(closing(open, "(", ")"));
        if (body >= end || tokens[body].text != "{")
            return {};
        return {std::string(tokens[name].text), type, closing(body, "{", "}") + 1};
    }

    std::size_t next(std::size_t i) const
    {
        do
            ++i;
        while (i < tokens.size() && tokens[i].kind == GlslToken::Kind::blank);
        return i;
    }

    // Of the bracket at `open`; the last token where it is not closed.
    std::size_t closing(std::size_t open, std::string_view opening, std::string_view ending) const
    {
        int depth = 0;
        for (std::size_t i = open; i < tokens.size(); ++i) {
            depth += tokens[i].text == opening ? 1 : 0;
            depth -= tokens[i].text == ending ? 1 : 0;
            if (depth == 0)
                return i;
        }
        return tokens.size() - 1;
    }

    const std::vector<GlslToken>& tokens;
};

std::set<std::string> wordsOf(std::span<const GlslToken> tokens)
{
    std::set<std::string> words;
    for (const GlslToken& token : tokens)
        if (token.kind == GlslToken::Kind::word)
            words.emplace(token.text);
    return words;
}

struct File
{
    std::vector<GlslToken> tokens;
    std::vector<Function> functions;
};

using Files = std::map<std::string, File>;

Files parsed(const ShaderSource& source)
{
    Files files;
    for (const auto& [name, text] : source.files) {
        File file = {.tokens = glslTokens(text), .functions = {}};
        file.functions = FunctionFinder(file.tokens).find();
        files.emplace(name, std::move(file));
    }
    return files;
}

// What stands outside functions, and main, uses the first names; the functions so named use more.
std::set<std::string> usedNames(const Files& files)
{
    std::multimap<std::string, std::set<std::string>> called;
    std::set<std::string> open = {"main"}, used;
    for (const auto& [name, file] : files) {
        std::size_t at = 0;
        const std::span<const GlslToken> tokens(file.tokens);
        for (const Function& function : file.functions) {
            called.emplace(function.name, wordsOf(tokens.subspan(function.first, function.last - function.first)));
            open.merge(wordsOf(tokens.subspan(at, function.first - at)));
            at = function.last;
        }
        open.merge(wordsOf(tokens.subspan(at)));
    }
    while (!open.empty()) {
        const std::string name = *open.begin();
        open.erase(open.begin());
        if (!used.insert(name).second)
            continue;
        for (auto [at, end] = called.equal_range(name); at != end; ++at)
            for (const std::string& word : at->second)
                if (!used.contains(word))
                    open.insert(word);
    }
    return used;
}

std::string textOf(const File& file, const std::set<std::string>& used, Precision precision)
{
    std::string text;
    auto function = file.functions.begin();
    for (std::size_t i = 0; i < file.tokens.size(); ++i) {
        if (function != file.functions.end() && i == function->first) {
            const Function& found = *function++;
            if (!used.contains(found.name)) {
                i = found.last - 1;
                continue;
            }
        }
        text += retypedToken(file.tokens[i], precision);
    }
    return text;
}

} // namespace

std::string retyped(std::string_view text, Precision precision)
{
    if (precision == Precision::fp32)
        return std::string(text);
    std::string result;
    for (const GlslToken& token : glslTokens(text))
        result += retypedToken(token, precision);
    return result;
}

ShaderSource retyped(ShaderSource source, Precision precision, const std::set<std::string>& kept)
{
    if (precision == Precision::fp32)
        return source;
    const Files files = parsed(source);
    const std::set<std::string> used = usedNames(files);
    std::map<std::string, std::string> changed;
    for (const auto& [name, file] : files)
        if (!kept.contains(name))
            changed.emplace(name, textOf(file, used, precision));
    for (auto& [name, text] : changed)
        source.files[name] = std::move(text);
    return source;
}

std::vector<std::string> unavailableFunctions(const ShaderSource& source, Precision precision)
{
    static const std::set<std::string_view> kBits = {"floatBitsToInt", "floatBitsToUint", "intBitsToFloat",
                                                     "uintBitsToFloat"};
    static const std::set<std::string_view> kSingleOnly = {
        "acos", "acosh", "asin", "asinh", "atan",    "atanh", "cos",  "cosh", "degrees", "exp",
        "exp2", "log",   "log2", "pow",   "radians", "sin",   "sinh", "tan",  "tanh"};
    std::set<std::string> found;
    for (const auto& [file, text] : source.files)
        for (const std::string& word : wordsOf(glslTokens(text)))
            if ((precision != Precision::fp32 && kBits.contains(word)) ||
                (precision == Precision::fp64 && kSingleOnly.contains(word)))
                found.insert(word);
    return {found.begin(), found.end()};
}

} // namespace torrance::gpu
