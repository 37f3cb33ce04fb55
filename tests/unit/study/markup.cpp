#include "study/markup.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD";

TEST(Markup, EscapesWhatBothFormatsGiveMeaningTo)
{
    EXPECT_EQ(markupEscaped("a<b> & \"c\" 'd'\t\n"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;&#9;&#10;");
    EXPECT_EQ(markupEscaped("κ ≤ 1 \xF0\x9F\x98\x80"), "κ ≤ 1 \xF0\x9F\x98\x80");
}

// XML 1.0, production 2 (Char), and the noncharacters that HTML forbids beside it.
TEST(Markup, ReplacesWhatNeitherFormatCanHold)
{
    for (const char* bad : {"\x01", "\x08", "\r", "\x1b", "\x7f", "\xC2\x80" /* U+0080 */, "\xEF\xBF\xBE" /* U+FFFE */,
                            "\xEF\xB7\x90" /* U+FDD0 */, "\xF0\x9F\xBF\xBF" /* U+1FFFF */})
        EXPECT_EQ(markupEscaped(bad), kReplacement);
    EXPECT_EQ(markupEscaped(std::string_view("\0", 1)), kReplacement);
}

// RFC 3629: an overlong form, a surrogate, beyond U+10FFFF, a lone continuation, a form that ends early.
TEST(Markup, ReplacesBytesThatAreNotUtf8)
{
    const std::string r = kReplacement;
    EXPECT_EQ(markupEscaped("\xC0\xBC"), r + r);
    EXPECT_EQ(markupEscaped("\xED\xA0\x80"), r + r + r);
    EXPECT_EQ(markupEscaped("\xF4\x90\x80\x80"), r + r + r + r);
    EXPECT_EQ(markupEscaped("a\x80z"), "a" + r + "z");
    EXPECT_EQ(markupEscaped("a\xE2\x82"), "a" + r + r);
    EXPECT_EQ(markupEscaped("\xE2\x82<"), r + r + "&lt;");
}

} // namespace
} // namespace torrance
