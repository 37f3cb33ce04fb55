#include "study/junit.h"

#include "study/markup.h"

#include <algorithm>
#include <fmt/format.h>

namespace torrance {
namespace {

struct Counts
{
    std::size_t tests = 0, failures = 0, skipped = 0;
};

Counts countsOf(std::span<const JunitSuite> suites)
{
    Counts counts;
    for (const JunitSuite& suite : suites)
        for (const JunitCase& c : suite.cases) {
            ++counts.tests;
            counts.failures += c.result == CaseResult::failed ? 1 : 0;
            counts.skipped += c.result == CaseResult::skipped ? 1 : 0;
        }
    return counts;
}

std::string attributes(std::string_view name, const Counts& counts)
{
    return fmt::format(R"(name="{}" tests="{}" failures="{}" errors="0" skipped="{}")", markupEscaped(name),
                       counts.tests, counts.failures, counts.skipped);
}

std::string element(std::string_view tag, const JunitCase& c)
{
    return fmt::format("      <{0} message=\"{1}\">{2}</{0}>\n", tag, markupEscaped(c.message),
                       markupEscaped(c.details));
}

std::string caseText(const JunitSuite& suite, const JunitCase& c)
{
    std::string text =
        fmt::format("    <testcase classname=\"{}\" name=\"{}\">\n", markupEscaped(suite.name), markupEscaped(c.name));
    if (c.result == CaseResult::failed)
        text += element("failure", c);
    else if (c.result == CaseResult::skipped)
        text += element("skipped", c);
    else if (!c.details.empty())
        text += fmt::format("      <system-out>{}</system-out>\n", markupEscaped(c.details));
    return text + "    </testcase>\n";
}

} // namespace

std::string junitText(std::string_view name, std::span<const JunitSuite> suites)
{
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    text += fmt::format("<testsuites {}>\n", attributes(name, countsOf(suites)));
    for (const JunitSuite& suite : suites) {
        text += fmt::format("  <testsuite {}>\n", attributes(suite.name, countsOf({&suite, 1})));
        for (const JunitCase& c : suite.cases)
            text += caseText(suite, c);
        text += "  </testsuite>\n";
    }
    return text + "</testsuites>\n";
}

} // namespace torrance
