// Results as JUnit XML, which build servers read.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace torrance {

enum class CaseResult
{
    passed,
    failed,
    skipped,
};

struct JunitCase
{
    std::string name;
    CaseResult result = CaseResult::passed;
    std::string message; // one line: why it failed or was skipped; may be empty where it passed
    std::string details; // any text; may be empty
};

struct JunitSuite
{
    std::string name;
    std::vector<JunitCase> cases;
};

/// UTF-8, of the element names and attributes that Jenkins, GitLab and GitHub's readers share: testsuites, testsuite,
/// testcase (with classname, the suite's name), failure, skipped. No times: the same results give the same bytes.
std::string junitText(std::string_view name, std::span<const JunitSuite> suites);

} // namespace torrance
