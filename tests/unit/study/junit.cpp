#include "study/junit.h"

#include "python.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

// What a reader finds: a line per element, in order, with its attributes and text as the parser gives them.
constexpr const char* kRead = R"(
import sys, xml.etree.ElementTree as tree
for e in tree.fromstring(sys.stdin.buffer.read()).iter():
    sys.stdout.buffer.write(repr((e.tag, sorted(e.attrib.items()), (e.text or '').strip(' \n'))).encode() + b'\n')
)";

TEST(Junit, IsReadBackByAParser)
{
    const JunitSuite suites[] = {
        {"probe", {{"D/ggx", CaseResult::passed, "", ""}, {"V/x", CaseResult::failed, "off", "a\nb"}}},
        {"furnace", {{"metal", CaseResult::skipped, "no device", ""}}}};
    EXPECT_EQ(
        test::python(kRead, junitText("conformance", suites)),
        "('testsuites', [('errors', '0'), ('failures', '1'), ('name', 'conformance'), ('skipped', '1'), ('tests', "
        "'3')], '')\n"
        "('testsuite', [('errors', '0'), ('failures', '1'), ('name', 'probe'), ('skipped', '0'), ('tests', "
        "'2')], '')\n"
        "('testcase', [('classname', 'probe'), ('name', 'D/ggx')], '')\n"
        "('testcase', [('classname', 'probe'), ('name', 'V/x')], '')\n"
        "('failure', [('message', 'off')], 'a\\nb')\n"
        "('testsuite', [('errors', '0'), ('failures', '0'), ('name', 'furnace'), ('skipped', '1'), ('tests', "
        "'1')], '')\n"
        "('testcase', [('classname', 'furnace'), ('name', 'metal')], '')\n"
        "('skipped', [('message', 'no device')], '')\n");
}

TEST(Junit, HoldsAnyText)
{
    using namespace std::string_literals;
    const std::string any = "<b a=\"1\" c='2'>&amp; \t\n\r\x01\x7f\0 \xC3\xA9 \xFF \xED\xA0\x80 ]]>"s;
    const JunitSuite suite{any, {{any, CaseResult::failed, any, any}}};
    const std::string seen = R"(<b a="1" c=\'2\'>&amp; \t\n???? é ? ??? ]]>)";
    std::string expected = seen; // the parser's repr, with U+FFFD for ?
    for (std::size_t at = 0; (at = expected.find('?', at)) != std::string::npos; at += 3)
        expected.replace(at, 1, "\xEF\xBF\xBD");
    const std::string read = test::python(kRead, junitText(any, {&suite, 1}));
    std::size_t count = 0;
    for (std::size_t at = read.find(expected); at != std::string::npos; at = read.find(expected, at + 1))
        ++count;
    EXPECT_EQ(count, 6u) << expected << "\nin\n" << read; // three names, a classname, a message, a text
}

} // namespace
} // namespace torrance
