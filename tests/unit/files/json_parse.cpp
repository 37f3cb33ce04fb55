#include "files/json_parse.h"

#include "core/error.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

template <typename Work>
std::string refusal(Work&& work)
{
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::input);
        return error.what();
    }
    ADD_FAILURE() << "nothing was refused";
    return "";
}

TEST(ParseJson, ReadsWhatWasWritten)
{
    const Json written = Json::Object{{"text", "a \"b\"\n"},
                                      {"whole", std::int64_t(-7)},
                                      {"number", 0.1},
                                      {"lost", std::numeric_limits<double>::quiet_NaN()},
                                      {"list", Json::Array{1, true, Json::Object{{"x", 2.5}}}}};
    EXPECT_EQ(jsonText(parseJson(jsonText(written), "a.json")).size(), jsonText(written).size());
    const Json read = parseJson(jsonText(written), "a.json");
    const JsonView view(read, "a.json");
    EXPECT_EQ(view.member("text").text(), "a \"b\"\n");
    EXPECT_EQ(view.member("whole").number(), -7.0);
    EXPECT_EQ(view.member("number").number(), 0.1);
    EXPECT_EQ(view.member("lost").numberOr(3.0), 3.0);
    EXPECT_EQ(view.member("number").numberOr(3.0), 0.1);
    ASSERT_EQ(view.member("list").elements().size(), 3u);
    EXPECT_EQ(view.member("list").elements()[2].member("x").number(), 2.5);
    EXPECT_TRUE(view.has("text"));
    EXPECT_FALSE(view.has("other"));
    EXPECT_EQ(JsonView(parseJson("18446744073709551615", "a.json"), "").number(), 18446744073709551616.0);
}

TEST(JsonView, NamesThePlaceOfWhatIsWrong)
{
    const Json json = parseJson(R"({"items": [{"n": 1}, {"n": "x"}]})", "a.json");
    const JsonView view(json, "a.json");
    const JsonView second = view.member("items").elements()[1];
    EXPECT_NE(refusal([&] { second.member("n").number(); }).find("a.json: /items/1/n: is no number"),
              std::string::npos);
    EXPECT_NE(refusal([&] { second.member("m").number(); }).find("a.json: /items/1/m: is missing"), std::string::npos);
    EXPECT_NE(refusal([&] { view.elements(); }).find("a.json: /: is no array"), std::string::npos);
    EXPECT_NE(refusal([&] { view.member("items").text(); }).find("is no text"), std::string::npos);
    EXPECT_NE(refusal([&] { view.member("items").member("n"); }).find("/items/n: is missing"), std::string::npos);
    EXPECT_NE(refusal([] { parseJson("{\"a\":", "a.json"); }).find("a.json"), std::string::npos);
}

} // namespace
} // namespace torrance
