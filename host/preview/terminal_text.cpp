#include "host/preview/terminal_text.hpp"

#include "host/preview/half_blocks.hpp"
#include "host/text/glyph.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast {
namespace {

constexpr std::string_view end_of_line = "\x1b[K\n"; // and nothing that stood there
constexpr std::string_view end_of_all = "\x1b[J";
constexpr std::string_view on_black = "\x1b[97;40m";
constexpr std::string_view plain = "\x1b[0m";

/// As much of `text` as goes on a line.
std::string cut(std::string_view text, int columns)
{
    std::string line;
    auto left = static_cast<std::size_t>(std::max(columns - 1, 0)); // the last column may wrap
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = code_point_at(text, at);
        const Glyph shown = glyph(point);
        if (shown.columns > left)
            break;
        line += shown.text;
        left -= shown.columns;
        at += point.length;
    }
    return line;
}

std::vector<std::string> lines_below(const TerminalContent& content, Size cells)
{
    std::vector<std::string> lines{cut(content.status, cells.width), cut(content.notice, cells.width)};
    const auto most = static_cast<std::size_t>(std::max(cells.height / 2, 1));
    const bool all = content.errors.size() <= most;
    const std::size_t count = all ? content.errors.size() : most - 1;
    for (const std::string& line : content.errors.first(count))
        lines.push_back(cut(line, cells.width));
    if (!all)
        lines.push_back("... and " + std::to_string(content.errors.size() - count) + " lines more");
    return lines;
}

/// A block of ASCII in as many columns as it takes to have at most `rows` lines.
std::vector<std::string> in_columns(std::span<const std::string> lines, std::size_t rows, int width)
{
    if (rows == 0 || lines.empty())
        return {};
    const std::size_t columns = (lines.size() + rows - 1) / rows;
    const int column_width = width / static_cast<int>(columns);
    std::vector<std::string> block(std::min(rows, lines.size()));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::string& row = block[i % rows];
        row.resize(static_cast<std::size_t>(column_width) * (i / rows), ' ');
        row += cut(lines[i], column_width);
    }
    const std::size_t longest = std::ranges::max(block, {}, &std::string::size).size();
    for (std::string& row : block)
        row.resize(longest, ' ');
    return block;
}

/// Written from below the picture, over its upper lines.
std::string help_over(std::span<const std::string> help, int lines, int width)
{
    const auto rows = in_columns(help, static_cast<std::size_t>(lines), width);
    std::string text = "\x1b[" + std::to_string(lines) + 'A';
    for (const std::string& row : rows)
        text.append(on_black).append(row).append(plain).append("\n");
    const int left = lines - static_cast<int>(rows.size());
    return left == 0 ? text : text + "\x1b[" + std::to_string(left) + 'B';
}

}

TerminalText terminal_text(const TerminalContent& content, Size cells, TerminalColours colours)
{
    const std::vector<std::string> below = lines_below(content, cells);
    const int space = std::max(1, cells.height - 1 - static_cast<int>(below.size()));
    const std::string picture = half_blocks(content.picture, {cells.width, space}, colours);
    std::string text;
    for (const char letter : picture)
        if (letter == '\n')
            text += end_of_line;
        else
            text += letter;
    int lines = static_cast<int>(std::ranges::count(picture, '\n'));
    for (; lines < std::min(space, static_cast<int>(content.help.size())); ++lines)
        text += end_of_line;
    if (!content.help.empty())
        text += help_over(content.help, lines, cells.width);
    for (const std::string& line : below)
        text.append(line).append(end_of_line);
    text += end_of_all;
    return {std::move(text), lines + static_cast<int>(below.size())};
}

}
