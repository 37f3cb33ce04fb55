// Documents that are edited keep the order of their members and every digit.
#include "files/json_ordered.h"

#include "core/error.h"

#include <chrono>
#include <gtest/gtest.h>

namespace torrance {
namespace {

TEST(JsonOrdered, KeepsOrderAndValues)
{
    const std::string text =
        R"({"z":1,"a":[true,null,{"y":"\u00e9\n","b":-0.0}],"m":{},"n":[],"i":18446744073709551615,)"
        R"("j":-9223372036854775808,"d":0.1,"e":1e-320,"s":[[],[{}]]})";
    const OrderedJson json = readOrderedJson(text, "a.gltf");
    EXPECT_EQ(json, OrderedJson::parse(text)) << "as the library's own reader has it";
    EXPECT_EQ(OrderedJson::parse(orderedJsonText(json, "")), json);
    EXPECT_EQ(json.begin().key(), "z");
}

TEST(JsonOrdered, ReadsPlainValuesAndByteOrderMarks)
{
    EXPECT_EQ(readOrderedJson("\xef\xbb\xbf[1]", "a"), OrderedJson::parse("[1]"));
    EXPECT_EQ(readOrderedJson("\"text\"", "a"), OrderedJson("text"));
}

TEST(JsonOrdered, RefusesWhatReadJsonRefuses)
{
    for (const char* text : {"", "{", "[1,]", R"({"a":1,"a":2})", "[1e999]", "\"\xff\""})
        EXPECT_THROW(readOrderedJson(text, "a"), Error) << text;
}

// An ordered object finds a member by going through all of them: read through that, these would take an hour.
TEST(JsonOrdered, ReadsObjectsOfManyMembersInTime)
{
    std::string text = "{";
    for (int i = 0; i < 200000; ++i)
        text += (i > 0 ? ",\"" : "\"") + std::to_string(i) + "\":0";
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(readOrderedJson(text + "}", "a").size(), 200000u);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5))
        << "a twentieth of a second, unless it is quadratic";
}

TEST(JsonOrdered, WritesWithTheIndentationOfAnother)
{
    const OrderedJson json = {{"a", {{"b", 1}}}};
    EXPECT_EQ(orderedJsonText(json, "{}"), R"({"a":{"b":1}})");
    EXPECT_EQ(orderedJsonText(json, "{\n}"), R"({"a":{"b":1}})");
    EXPECT_EQ(orderedJsonText(json, "{\n   \"x\": 1\n}"), "{\n   \"a\": {\n      \"b\": 1\n   }\n}");
    EXPECT_EQ(orderedJsonText(json, "{\r\n\t\"x\": 1\r\n}"), "{\n\t\"a\": {\n\t\t\"b\": 1\n\t}\n}");
    EXPECT_EQ(orderedJsonText(json, "\n\n{\n \"x\""), "{\n \"a\": {\n  \"b\": 1\n }\n}");
}

} // namespace
} // namespace torrance
