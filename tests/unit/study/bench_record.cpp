#include "study/bench_record.h"

#include "core/error.h"

#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

BenchResult resultOf(const std::string& name, double median, double low, double high)
{
    BenchResult result;
    result.name = name;
    result.width = 64;
    result.height = 48;
    result.methods = "standard ggx";
    result.triangles = 12;
    result.processor = {.median = median, .low = low, .high = high, .count = 30};
    result.wall = {.median = 0.5 * median, .low = -kInfinity, .high = kInfinity, .count = 4};
    return result;
}

BenchRecord recordOf(std::vector<BenchResult> results)
{
    BenchRecord record;
    record.program = "torrance";
    record.machine = {.processor = "Z80", .cores = 2, .system = "CP/M", .device = "llvmpipe", .driver = "Mesa 22"};
    record.results = std::move(results);
    return record;
}

BenchRecord written(const BenchRecord& record)
{
    return parseBenchRecord(jsonText(asJson(record)), "old.json");
}

std::string refusal(const std::function<void()>& work)
{
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::input) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "nothing was refused";
    return "";
}

TEST(BenchRecord, IsReadAsItWasWritten)
{
    const BenchRecord record = written(recordOf({resultOf("a", 0.010, 0.009, 0.012), resultOf("b", 3.0, 2.0, 4.0)}));
    EXPECT_EQ(record.machine.processor, "Z80");
    EXPECT_EQ(record.machine.cores, 2);
    EXPECT_EQ(record.machine.device, "llvmpipe");
    EXPECT_EQ(record.machine.driver, "Mesa 22");
    ASSERT_EQ(record.results.size(), 2u);
    const BenchResult& a = record.results[0];
    EXPECT_EQ(a.name, "a");
    EXPECT_EQ(a.width, 64);
    EXPECT_EQ(a.height, 48);
    EXPECT_EQ(a.triangles, 12u);
    EXPECT_EQ(a.methods, "standard ggx");
    EXPECT_DOUBLE_EQ(a.processor.median, 0.010);
    EXPECT_DOUBLE_EQ(a.processor.low, 0.009);
    EXPECT_DOUBLE_EQ(a.processor.high, 0.012);
    EXPECT_EQ(a.processor.count, 30u);
    EXPECT_EQ(a.wall.low, -kInfinity) << "null: there was no interval";
    EXPECT_EQ(a.wall.high, kInfinity);
}

TEST(BenchRecord, RefusesWhatIsNone)
{
    EXPECT_NE(refusal([] { parseBenchRecord("{", "old.json"); }).find("old.json"), std::string::npos);
    EXPECT_NE(refusal([] { parseBenchRecord("[]", "old.json"); }).find("/schema: is missing"), std::string::npos);
    EXPECT_NE(refusal([] { parseBenchRecord(R"({"schema": "torrance-bench/0"})", "old.json"); }).find("bench/0"),
              std::string::npos);
    std::string text = jsonText(asJson(recordOf({resultOf("a", 1.0, 0.9, 1.1)})));
    const std::string median = "\"median\": 1000.0";
    ASSERT_NE(text.find(median), std::string::npos) << text;
    text.replace(text.find(median), median.size(), "\"median\": -1.0");
    EXPECT_NE(refusal([&] { parseBenchRecord(text, "old.json"); }).find("/results/0/cpu_ms"), std::string::npos);
}

// The verdict is on the ratio's interval, which allows for both: 1.30 / 1.05 = 1.238 to 1.40 / 0.95 = 1.474.
TEST(CompareSpeed, CallsSlowerWhatIsSureToBe)
{
    const BenchRecord then = recordOf({resultOf("a", 1.0, 0.95, 1.05)});
    const auto verdict = [&](const BenchResult& now, double limit) {
        const std::vector<SpeedComparison> comparisons = compareSpeed(then, recordOf({now}), limit);
        EXPECT_EQ(comparisons.size(), 1u);
        return comparisons.front().verdict;
    };
    const BenchResult slow = resultOf("a", 1.35, 1.30, 1.40);
    EXPECT_EQ(verdict(slow, 1.2), SpeedVerdict::slower);
    EXPECT_EQ(verdict(slow, 1.3), SpeedVerdict::perhapsSlower);
    EXPECT_EQ(verdict(slow, 1.4), SpeedVerdict::asFast);
    EXPECT_EQ(verdict(resultOf("a", 0.5, 0.49, 0.51), 1.1), SpeedVerdict::faster);
    EXPECT_EQ(verdict(resultOf("a", 2.0, -kInfinity, kInfinity), 1.1), SpeedVerdict::perhapsSlower) << "too few frames";
}

TEST(CompareSpeed, ComparesOnlyLikeWithLike)
{
    const BenchRecord then = recordOf({resultOf("a", 1.0, 0.9, 1.1), resultOf("b", 1.0, 0.9, 1.1)});
    const auto refusedFor = [&](BenchRecord now) { return refusal([&] { requireComparable(then, "old.json", now); }); };
    EXPECT_NO_THROW(requireComparable(then, "old.json", recordOf({resultOf("b", 9.0, 8.0, 10.0)})));
    BenchRecord now = then;
    now.machine.device = "RTX";
    EXPECT_NE(refusedFor(now).find("llvmpipe with Mesa 22, and RTX with Mesa 22 now"), std::string::npos);
    now = then;
    now.machine.driver = "Mesa 23";
    EXPECT_NE(refusedFor(now).find("Mesa 23"), std::string::npos);
    now = then;
    now.machine.cores = 4;
    EXPECT_NE(refusedFor(now).find("4 of Z80"), std::string::npos);
    now = recordOf({resultOf("c", 1.0, 0.9, 1.1)});
    EXPECT_NE(refusedFor(now).find("has no c"), std::string::npos);
    now = then;
    now.results[1].width = 65;
    EXPECT_NE(refusedFor(now).find("b: was measured with 64x48, and 65x48 now"), std::string::npos);
    now = then;
    now.results[0].samples = 4;
    EXPECT_NE(refusedFor(now).find("1 samples, and 4 now"), std::string::npos);
    now = then;
    now.results[0].triangles = 13;
    EXPECT_NE(refusedFor(now).find("12 triangles, and 13 now"), std::string::npos);
    now = then;
    now.results[0].methods = "standard beckmann";
    EXPECT_NE(refusedFor(now).find("other methods"), std::string::npos);
}

} // namespace
} // namespace torrance
