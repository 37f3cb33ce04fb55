#include "files/csv_read.h"

#include "core/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace torrance {
namespace {

std::string lineItem(std::size_t line)
{
    return "line " + std::to_string(line);
}

class Reader
{
public:
    Reader(std::string_view t, const std::string& f) : text(t), file(f)
    {
        if (text.starts_with("\xEF\xBB\xBF"))
            at = 3;
    }

    bool atEnd() const { return at >= text.size(); }

    /// The cells up to the end of the line or of the text.
    std::vector<std::string> line()
    {
        std::vector<std::string> cells(1);
        for (; !atEnd(); ++at) {
            const char c = text[at];
            if (c == '"')
                quoted(cells.back());
            else if (c == ',')
                cells.emplace_back();
            else if (c == '\n')
                break;
            else if (c != '\r' || (at + 1 < text.size() && text[at + 1] != '\n'))
                cells.back() += c;
        }
        ++at;
        ++number;
        return cells;
    }

    std::size_t number = 1; // of the line that comes next

private:
    /// `at` is the opening quote, and then the closing one.
    void quoted(std::string& cell)
    {
        const std::size_t opened = number;
        for (++at; !atEnd(); ++at) {
            if (text[at] == '\n')
                ++number;
            if (text[at] != '"')
                cell += text[at];
            else if (at + 1 < text.size() && text[at + 1] == '"')
                cell += text[++at];
            else
                return;
        }
        throw inputError(file, lineItem(opened), "a quote is not closed", "close it");
    }

    std::string_view text;
    const std::string& file;
    std::size_t at = 0;
};

bool isEmptyLine(const std::vector<std::string>& cells)
{
    return cells.size() == 1 && cells.front().empty();
}

void checkColumns(const std::vector<std::string>& columns, const std::string& file)
{
    if (columns.empty() || isEmptyLine(columns))
        throw inputError(file, "", "has no line of column names", "name the columns in the first line");
    std::vector<std::string> sorted = columns;
    std::ranges::sort(sorted);
    const auto twice = std::ranges::adjacent_find(sorted);
    if (twice != sorted.end())
        throw inputError(file, "column " + *twice, "is named twice", "rename one");
}

} // namespace

CsvTable parseCsv(std::string_view text, const std::string& file)
{
    Reader reader(text, file);
    CsvTable table;
    if (!reader.atEnd())
        table.columns = reader.line();
    checkColumns(table.columns, file);
    while (!reader.atEnd()) {
        const std::size_t line = reader.number;
        std::vector<std::string> cells = reader.line();
        if (isEmptyLine(cells))
            continue;
        if (cells.size() != table.columns.size())
            throw inputError(file, lineItem(line),
                             "has " + std::to_string(cells.size()) + " cells where there are " +
                                 std::to_string(table.columns.size()) + " columns",
                             "complete it");
        table.rows.push_back(std::move(cells));
        table.lines.push_back(line);
    }
    return table;
}

std::size_t CsvTable::column(std::string_view name, const std::string& file) const
{
    const auto found = std::ranges::find(columns, name);
    if (found == columns.end())
        throw inputError(file, "column " + std::string(name), "is missing", "add it");
    return static_cast<std::size_t>(found - columns.begin());
}

double csvNumber(const CsvTable& table, std::size_t row, std::size_t column, const std::string& file)
{
    const std::string& cell = table.rows[row][column];
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    const bool whole = error == std::errc() && end == cell.data() + cell.size();
    if (!whole || !std::isfinite(value))
        throw inputError(file, lineItem(table.lines[row]) + ", column " + table.columns[column],
                         "'" + cell.substr(0, 40) + "' is not a finite number", "write one, such as 0.5 or 1e-3");
    return value;
}

std::string csvCell(std::string_view text)
{
    if (text.find_first_of(",\"\r\n") == std::string_view::npos)
        return std::string(text);
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

} // namespace torrance
