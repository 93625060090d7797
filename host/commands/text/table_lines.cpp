#include "host/commands/text/table_lines.hpp"

#include <algorithm>
#include <cstddef>

namespace kfast {
namespace {

std::vector<std::size_t> column_widths(const std::vector<TableRow>& rows)
{
    std::vector<std::size_t> widths;
    for (const TableRow& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t column = 0; column < row.size(); ++column)
            widths[column] = std::max(widths[column], row[column].size());
    }
    return widths;
}

}

std::vector<std::string> table_lines(const std::vector<TableRow>& rows, const std::string& indent)
{
    const std::vector<std::size_t> widths = column_widths(rows);
    std::vector<std::string> lines;
    for (const TableRow& row : rows) {
        std::string line = indent;
        for (std::size_t column = 0; column < row.size(); ++column)
            line += row[column] + std::string(widths[column] - row[column].size() + 2, ' ');
        lines.push_back(line.erase(line.find_last_not_of(' ') + 1));
    }
    return lines;
}

std::string table_text(const std::vector<TableRow>& rows)
{
    std::string text;
    for (const std::string& line : table_lines(rows))
        text += line + '\n';
    return text;
}

}
