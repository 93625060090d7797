#pragma once

#include <string>
#include <vector>

namespace kfast {

/// Cells of a line, from left to right.
using TableRow = std::vector<std::string>;

/// Every row as a line: the cells of a column begin below each other, two spaces behind the widest one of the
/// column before. No line ends in spaces. Rows may have different numbers of cells.
std::vector<std::string> table_lines(const std::vector<TableRow>& rows, const std::string& indent = "");

/// The same as a text, for standard output.
std::string table_text(const std::vector<TableRow>& rows);

}
