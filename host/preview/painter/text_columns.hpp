#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// How many columns a line of UTF-8 takes in a window.
int columns_of(std::string_view text);

/// The beginning of a text, of at most `columns` columns.
std::string_view first_columns(std::string_view text, int columns);

/// As much as fits into `columns` columns; where something is left out, it ends in "…". Empty if there is no
/// column.
std::string cut(std::string_view text, int columns);

/// Lines of at most `columns` columns, at least 1, broken at spaces where that is possible. The lines after
/// the first begin with as many spaces as the text does, and with `hang` more where that leaves room for
/// words.
std::vector<std::string> wrapped(std::string_view text, int columns, int hang = 0);

}
