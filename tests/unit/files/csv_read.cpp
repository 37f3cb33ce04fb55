#include "files/csv_read.h"

#include "core/error.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

std::string problemOf(std::string_view text)
{
    try {
        const CsvTable table = parseCsv(text, "t.csv");
        for (std::size_t row = 0; row < table.rows.size(); ++row)
            csvNumber(table, row, table.column("x", "t.csv"), "t.csv");
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::input);
        return error.what();
    }
    return "";
}

TEST(Csv, ReadsQuotesLineEndsAndEmptyLines)
{
    const CsvTable table = parseCsv("\xEF\xBB\xBFid,label\r\n1,\"a, \"\"b\"\"\nc\"\r\n\r\n2,\n3,d", "t.csv");
    EXPECT_EQ(table.columns, (std::vector<std::string>{"id", "label"}));
    ASSERT_EQ(table.rows.size(), 3u);
    EXPECT_EQ(table.rows[0], (std::vector<std::string>{"1", "a, \"b\"\nc"}));
    EXPECT_EQ(table.rows[1], (std::vector<std::string>{"2", ""}));
    EXPECT_EQ(table.rows[2], (std::vector<std::string>{"3", "d"}));
    EXPECT_EQ(table.lines, (std::vector<std::size_t>{2, 5, 6}))
        << "the quoted cell takes two lines, the empty one is counted";
    EXPECT_EQ(csvCell("a, \"b\"\nc"), "\"a, \"\"b\"\"\nc\"");
    EXPECT_EQ(csvCell("plain"), "plain");
}

TEST(Csv, KeepsNumbersToTheLastDigit)
{
    const CsvTable table = parseCsv("x\n-0.5400828\n1e-300\n5.8344666464442942e-1\n", "t.csv");
    EXPECT_EQ(csvNumber(table, 0, 0, "t.csv"), -0.5400828);
    EXPECT_EQ(csvNumber(table, 1, 0, "t.csv"), 1e-300);
    EXPECT_EQ(csvNumber(table, 2, 0, "t.csv"), 5.8344666464442942e-1);
}

TEST(Csv, NamesFileLineAndColumnOfWhatIsWrong)
{
    EXPECT_EQ(problemOf("x\n1\n"), "");
    EXPECT_NE(problemOf("").find("t.csv: has no line of column names"), std::string::npos);
    EXPECT_NE(problemOf("y\n1\n").find("t.csv: column x: is missing"), std::string::npos);
    EXPECT_NE(problemOf("x,x\n1,1\n").find("column x: is named twice"), std::string::npos);
    EXPECT_NE(problemOf("x,y\n1,2\n3\n").find("t.csv: line 3: has 1 cells where there are 2 columns"),
              std::string::npos);
    EXPECT_NE(problemOf("x\n\"1\n").find("line 2: a quote is not closed"), std::string::npos);
    for (const char* bad : {"nan", "inf", "1e999", "0x1", "1.0f", " 1", "one", "1 2"})
        EXPECT_NE(problemOf(std::string("x\n") + bad + "\n").find("t.csv: line 2, column x: '"), std::string::npos)
            << bad;
}

} // namespace
} // namespace torrance
