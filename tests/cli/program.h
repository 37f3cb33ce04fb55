// Runs the built program the way a shell does.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace torrance::test {

struct Outcome
{
    int exitCode = -1; // 128 + number where a signal ended it
    std::string output;
    std::string errors;
};

/// `torrance arguments...`, with an empty standard input. Extra environment variables as NAME=VALUE. Standard output
/// goes to `outputFile` where that is given, and Outcome::output is empty then. `meanwhile` is called with the
/// process's number while it runs.
Outcome runTorrance(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {},
                    const std::string& outputFile = "", const std::function<void(int process)>& meanwhile = {});

/// A file's bytes; empty where there is none.
std::string contentOf(const std::filesystem::path& path);

/// Exactly one line, as errors are.
bool isOneLine(const std::string& text);

/// An empty folder of the running test's own, removed with the object.
class TestFolder
{
public:
    TestFolder();
    ~TestFolder();
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    std::string file(const std::string& name) const { return (path / name).string(); }
    /// The bytes of a file in it.
    std::string content(const std::string& name) const { return contentOf(file(name)); }
    /// Names of what lies in it, sorted: to see that nothing was left behind.
    std::vector<std::string> names() const;

    std::filesystem::path path;
};

} // namespace torrance::test
