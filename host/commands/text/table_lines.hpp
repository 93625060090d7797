#pragma once

#include <string>
#include <vector>

namespace kfast {

/// The cells of a line, from left to right. A byte counts as a column, so that they should be ASCII.
using TableRow = std::vector<std::string>;

/// Writes every row as a line without its end. The cells of a column begin below each other, two spaces
/// after the widest cell of the column before; `indent` is put before each line, and no line ends in spaces.
/// Rows may have different numbers of cells.
std::vector<std::string> table_lines(const std::vector<TableRow>& rows, const std::string& indent = "");

/// Returns the same lines, not indented, as one text in which each of them ends with "\n".
std::string table_text(const std::vector<TableRow>& rows);

}
