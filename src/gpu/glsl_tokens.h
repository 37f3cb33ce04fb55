// GLSL cut into words, numbers and the rest.
#pragma once

#include <string_view>
#include <vector>

namespace torrance::gpu {

struct GlslToken
{
    enum class Kind
    {
        word,        // a name or a keyword
        number,      // a literal with its suffix
        blank,       // spaces and comments
        punctuation, // one character, or a string in quotes
    };
    Kind kind = Kind::blank;
    std::string_view text;
};

/// In order; their texts put together are `text`, to which they point. Directives are cut like code.
std::vector<GlslToken> glslTokens(std::string_view text);

/// True for 1.0, .5, 1e-3 and 2f; false for 1, 7u and 0x1e5.
bool isFloatLiteral(std::string_view number);

} // namespace torrance::gpu
