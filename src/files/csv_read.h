// Tables of comma-separated values (RFC 4180): a line of column names, then rows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace torrance {

struct CsvTable
{
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows; // as many cells each as there are columns
    std::vector<std::size_t> lines;             // of the file, from 1, where each row starts

    /// Index of a column; an Error (input) names `file` and the column where there is none.
    std::size_t column(std::string_view name, const std::string& file) const;
};

/// Cells may stand in double quotes, in which "" is one quote and commas and line breaks are text. Lines end in LF or
/// CRLF; empty lines are skipped, and so is a byte order mark. Errors (input) name `file` and the line: no header, a
/// column named twice, a row with more or fewer cells, an open quote.
CsvTable parseCsv(std::string_view text, const std::string& file);

/// The cell as a finite number, all of it; Errors (input) name `file`, the line and the column.
double csvNumber(const CsvTable& table, std::size_t row, std::size_t column, const std::string& file);

/// A cell as it is written: in quotes where it holds a comma, a quote or a line break.
std::string csvCell(std::string_view text);

} // namespace torrance
