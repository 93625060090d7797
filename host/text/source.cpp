#include "host/text/source.hpp"

#include "host/text/utf8.hpp"

#include <algorithm>

namespace kfast {

namespace {

constexpr std::string_view line_ends = "\n\r";

/// Whether a line ends just before `offset`; between CR and LF it has not ended yet.
bool line_ends_before(std::string_view text, std::size_t offset)
{
    const char last = text[offset - 1];
    return last == '\n' || (last == '\r' && (offset == text.size() || text[offset] != '\n'));
}

std::size_t line_begin(std::string_view text, std::size_t offset)
{
    while (offset > 0 && !line_ends_before(text, offset))
        --offset;
    return offset;
}

std::size_t lines_ended_before(std::string_view text, std::size_t offset)
{
    std::size_t count = 0;
    for (std::size_t at = 1; at <= offset; ++at)
        count += line_ends_before(text, at) ? 1 : 0;
    return count;
}

std::size_t column_of(std::string_view text, std::size_t begin, std::size_t offset)
{
    std::size_t column = 1;
    while (begin < offset) {
        begin += code_point_at(text, begin).length;
        column += begin <= offset ? 1 : 0;
    }
    return column;
}

}

LineColumn line_column(std::string_view text, std::size_t offset)
{
    offset = std::min(offset, text.size());
    const std::size_t begin = line_begin(text, offset);
    return {.line = 1 + lines_ended_before(text, begin), .column = column_of(text, begin, offset)};
}

std::string_view line_at(std::string_view text, std::size_t offset)
{
    offset = std::min(offset, text.size());
    const std::size_t begin = line_begin(text, offset);
    return text.substr(begin, text.find_first_of(line_ends, begin) - begin);
}

}
