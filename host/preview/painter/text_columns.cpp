#include "host/preview/painter/text_columns.hpp"

#include "core/bytes/code_point.hpp"

#include <algorithm>

namespace kfast {
namespace {

/// The number of bytes of the first columns of a text.
std::size_t bytes_of(std::string_view text, int columns)
{
    std::size_t at = 0;
    for (; columns > 0 && at < text.size(); --columns)
        at += code_point_at(text, at).length;
    return at;
}

/// Where a line of at most `bytes` ends: before the last spaces in it, or where it is full.
std::size_t line_end(std::string_view text, std::size_t bytes)
{
    if (bytes == text.size())
        return bytes;
    const std::size_t space = text.rfind(' ', bytes);
    const std::size_t word = text.find_first_not_of(' ');
    const bool is_one_word = space == std::string_view::npos || space <= word;
    return is_one_word ? bytes : text.find_last_not_of(' ', space) + 1;
}

}

int columns_of(std::string_view text)
{
    int columns = 0;
    for (std::size_t at = 0; at < text.size(); at += code_point_at(text, at).length)
        ++columns;
    return columns;
}

std::string_view first_columns(std::string_view text, int columns)
{
    return text.substr(0, bytes_of(text, columns));
}

std::string cut(std::string_view text, int columns)
{
    if (columns <= 0)
        return "";
    if (columns_of(text) <= columns)
        return std::string{text};
    return std::string{first_columns(text, columns - 1)} + "…";
}

std::vector<std::string> wrapped(std::string_view text, int columns, int hang)
{
    const auto begin = static_cast<int>(std::min(text.find_first_not_of(' '), text.size()));
    int indent = begin < columns ? begin : 0;
    text.remove_prefix(static_cast<std::size_t>(begin));
    std::vector<std::string> lines;
    do {
        const std::size_t end = line_end(text, bytes_of(text, columns - indent));
        lines.push_back(std::string(static_cast<std::size_t>(indent), ' ').append(text.substr(0, end)));
        text.remove_prefix(std::min(text.find_first_not_of(' ', end), text.size()));
        if (lines.size() == 1 && indent + hang < columns)
            indent += hang;
    } while (!text.empty());
    return lines;
}

}
