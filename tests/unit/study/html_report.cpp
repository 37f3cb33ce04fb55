#include "study/html_report.h"

#include "python.h"
#include "study/base64.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

// Every element closed in order; then the text, and the pictures' sizes and first pixels as Python's own zlib sees
// them.
constexpr const char* kRead = R"(
import base64, html.parser, re, struct, sys, zlib
class Reader(html.parser.HTMLParser):
    open = []
    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == 'img':
            png = base64.b64decode(attributes['src'].removeprefix('data:image/png;base64,'), validate=True)
            size = struct.unpack('>II', png[16:24])
            stream, at = b'', 8
            while at < len(png):
                length, kind = struct.unpack('>I4s', png[at:at + 8])
                stream += png[at + 8:at + 8 + length] if kind == b'IDAT' else b''
                at += 12 + length
            data = zlib.decompress(stream)
            print('img', attributes['width'], attributes['height'], size, list(data[1:4]), attributes['alt'])
        elif tag != 'meta':
            self.open.append(tag)
        assert 'href' not in attributes or tag == 'a' and ':' not in attributes['href'], attributes
        assert not attributes.get('src', 'data:').startswith('http'), attributes
    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag
    def handle_data(self, data):
        if data.strip() and self.open[-1] != 'style':
            print(self.open[-1], repr(data))
reader = Reader()
text = sys.stdin.buffer.read().decode()
assert text.startswith('<!DOCTYPE html>\n')
reader.feed(text)
reader.close()
assert not reader.open, reader.open
)";

TEST(HtmlReport, IsReadBackByAParser)
{
    Image red(2, 1, 3);
    red.texels = {1, 0, 0, 0, 1, 0};
    HtmlReport report;
    report.title = "A & B";
    report.parts = {HtmlHeading{"Spheres", 2}, HtmlParagraph{"r < 0.1 \"so\" <script>"},
                    HtmlTable{{"case", "worst"}, {{"ball", {"3 > 1", HtmlMark::bad}}}},
                    HtmlPictures{{{red, "drawn <1>", 4}}}, HtmlLinks{{{"a table", "a&b.csv"}, {"below", "#Spheres"}}}};
    EXPECT_EQ(test::python(kRead, htmlText(report)), "title 'A & B'\nh1 'A & B'\nh2 'Spheres'\n"
                                                     "p 'r < 0.1 \"so\" <script>'\n"
                                                     "th 'case'\nth 'worst'\ntd 'ball'\ntd '3 > 1'\n"
                                                     "img 8 4 (2, 1) [255, 0, 0] drawn <1>\nfigcaption 'drawn <1>'\n"
                                                     "a 'a table'\np ' · '\na 'below'\n");
    EXPECT_NE(htmlText(report).find("<a href=\"a&amp;b.csv\">"), std::string::npos);
    EXPECT_NE(htmlText(report).find("<h2 id=\"Spheres\">"), std::string::npos);
}

// RFC 4648, section 10.
TEST(Base64, GivesTheVectorsOfTheStandard)
{
    const auto of = [](std::string_view text) { return base64(std::as_bytes(std::span(text))); };
    EXPECT_EQ(of(""), "");
    EXPECT_EQ(of("f"), "Zg==");
    EXPECT_EQ(of("fo"), "Zm8=");
    EXPECT_EQ(of("foo"), "Zm9v");
    EXPECT_EQ(of("foob"), "Zm9vYg==");
    EXPECT_EQ(of("fooba"), "Zm9vYmE=");
    EXPECT_EQ(of("foobar"), "Zm9vYmFy");
    EXPECT_EQ(of("\xFB\xFF\xBF"), "+/+/");
}

} // namespace
} // namespace torrance
