#include "python.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace torrance::test {
namespace {

std::filesystem::path keep(const std::string& name, std::string_view text)
{
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("torrance-" + std::to_string(getpid()) + name);
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

} // namespace

std::string python(std::string_view script, std::string_view text)
{
    const std::filesystem::path code = keep(".py", script);
    const std::filesystem::path input = keep(".txt", text);
    const std::string command =
        std::string(TORRANCE_PYTHON) + " '" + code.string() + "' < '" + input.string() + "' 2>&1";
    std::string output;
    FILE* const pipe = popen(command.c_str(), "r");
    std::array<char, 4096> block{};
    for (std::size_t n = 0; pipe != nullptr && (n = fread(block.data(), 1, block.size(), pipe)) > 0;)
        output.append(block.data(), n);
    const int status = pipe == nullptr ? -1 : pclose(pipe);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << output;
    std::filesystem::remove(code);
    std::filesystem::remove(input);
    return output;
}

} // namespace torrance::test
