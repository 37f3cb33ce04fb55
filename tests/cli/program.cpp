#include "program.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace torrance::test {
namespace {

std::vector<char*> pointers(std::vector<std::string>& texts)
{
    std::vector<char*> result;
    for (std::string& text : texts)
        result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

int exitCodeOf(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

} // namespace

std::string contentOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Outcome runTorrance(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                    const std::string& outputFile, const std::function<void(int process)>& meanwhile)
{
    const TestFolder folder;
    const std::string output = outputFile.empty() ? folder.file("output") : outputFile, errors = folder.file("errors");
    std::vector<std::string> words = {TORRANCE_BINARY_DIR "/bin/torrance"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables = environment; // first: a name that occurs twice is taken from the front
#ifdef __SANITIZE_ADDRESS__
    // The driver leaks 112 bytes and is unloaded before the report, so that no suppression can name it. Leaks of the
    // program's own are looked for by the unit tests.
    variables.emplace_back("ASAN_OPTIONS=detect_leaks=0");
#endif
    for (char** variable = environ; *variable != nullptr; ++variable)
        variables.emplace_back(*variable);

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, 1, output.c_str(), O_WRONLY | O_CREAT, 0600);
    posix_spawn_file_actions_addopen(&files, 2, errors.c_str(), O_WRONLY | O_CREAT, 0600);
    pid_t child = 0;
    const int failure =
        posix_spawn(&child, words[0].c_str(), &files, nullptr, pointers(words).data(), pointers(variables).data());
    posix_spawn_file_actions_destroy(&files);
    EXPECT_EQ(failure, 0) << "cannot start " << words[0];
    if (failure == 0 && meanwhile)
        meanwhile(child);
    int status = 0;
    while (failure == 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    return {.exitCode = exitCodeOf(status),
            .output = outputFile.empty() ? contentOf(output) : "",
            .errors = contentOf(errors)};
}

bool isOneLine(const std::string& text)
{
    return text.size() > 1 && text.find('\n') == text.size() - 1;
}

TestFolder::TestFolder()
{
    std::string name = (std::filesystem::temp_directory_path() / "torrance-test-XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr) << name;
    path = name;
}

TestFolder::~TestFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

std::vector<std::string> TestFolder::names() const
{
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(path))
        result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
}

} // namespace torrance::test
