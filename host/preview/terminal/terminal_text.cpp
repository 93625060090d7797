#include "host/preview/terminal/terminal_text.hpp"

#include "host/preview/painter/scaled_picture.hpp"
#include "host/preview/painter/text_columns.hpp"
#include "host/preview/terminal/half_blocks.hpp"
#include "host/preview/viewer/beside.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast {
namespace {

constexpr std::string_view end_of_line = "\x1b[K\n"; // clears the rest of the line
constexpr std::string_view end_of_all = "\x1b[J";
constexpr std::string_view on_black = "\x1b[97;40m";
constexpr std::string_view plain = "\x1b[0m";

/// As much of `text` as fits on a line of a terminal, where some letters take two columns or none.
std::string line_within(std::string_view text, int columns)
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

/// The status, and at its right the hint if both have room on the line.
std::string status_line(const TerminalContent& content, int columns)
{
    constexpr int gap = 2;
    std::string line = line_within(content.status, columns);
    const int left = columns - 1 - columns_of(line) - columns_of(content.hint);
    if (content.hint.empty() || left < gap)
        return line;
    return line.append(static_cast<std::size_t>(left), ' ').append(content.hint);
}

std::vector<std::string> lines_below(const TerminalContent& content, Size cells)
{
    std::vector<std::string> lines{status_line(content, cells.width),
                                   line_within(content.notice, cells.width)};
    const auto max = static_cast<std::size_t>(std::max(cells.height / 2, 1));
    const bool all = content.errors.size() <= max;
    const std::size_t count = all ? content.errors.size() : max - 1;
    for (const std::string& line : content.errors.first(count))
        lines.push_back(line_within(line, cells.width));
    if (!all)
        lines.push_back("... and " + std::to_string(content.errors.size() - count) + " lines more");
    return lines;
}

/// Both pictures with their captions, each line with its end.
std::string pictures_beside(const TerminalContent& content, Size space, TerminalColours colours)
{
    const Picture both = joined(content.picture, *content.beside);
    const Size room{space.width, std::max(1, space.height - 1)};
    const Size pixels{room.width, room.height * 2};
    const bool fits = both.size.width <= pixels.width && both.size.height <= pixels.height;
    const int columns = fits ? both.size.width : placement(both.size, pixels).width;
    const int right = right_column(content.picture, *content.beside, columns);
    std::string captions = line_within(this_computer, right);
    captions.append(static_cast<std::size_t>(std::max(0, right - columns_of(captions))), ' ');
    return half_blocks(both, room, colours) + line_within(captions + content.caption, space.width) + '\n';
}

std::string picture_lines(const TerminalContent& content, Size space, TerminalColours colours)
{
    return content.beside == nullptr ? half_blocks(content.picture, space, colours)
                                     : pictures_beside(content, space, colours);
}

/// Lines of equal length, for colours after them.
std::vector<std::string> block_of(const HelpPage& page)
{
    std::vector<std::string> rows(static_cast<std::size_t>(page.cells.height));
    for (const HelpLine& line : page.lines) {
        std::string& row = rows[static_cast<std::size_t>(line.row)];
        row.append(static_cast<std::size_t>(line.column - columns_of(row)), ' ').append(line.text);
    }
    for (std::string& row : rows)
        row.append(static_cast<std::size_t>(page.cells.width - columns_of(row)), ' ');
    return rows;
}

/// Written from below the picture, over its upper lines.
std::string help_over(const HelpPage& page, int lines)
{
    std::string text = "\x1b[" + std::to_string(lines) + 'A';
    for (const std::string& row : block_of(page))
        text.append(on_black).append(row).append(plain).append("\n");
    const int left = lines - page.cells.height;
    return left == 0 ? text : text + "\x1b[" + std::to_string(left) + 'B';
}

}

TerminalText terminal_text(const TerminalContent& content, Size cells, TerminalColours colours)
{
    const std::vector<std::string> below = lines_below(content, cells);
    const int space = std::max(1, cells.height - 1 - static_cast<int>(below.size()));
    const std::string picture = picture_lines(content, {cells.width, space}, colours);
    std::string text;
    for (const char letter : picture)
        if (letter == '\n')
            text += end_of_line;
        else
            text += letter;
    int lines = static_cast<int>(std::ranges::count(picture, '\n'));
    if (content.help != nullptr) {
        const HelpPage page = content.help->page({cells.width - 1, space});
        for (; lines < page.cells.height; ++lines)
            text += end_of_line;
        text += help_over(page, lines);
    }
    for (const std::string& line : below)
        text.append(line).append(end_of_line);
    text += end_of_all;
    return {std::move(text), lines + static_cast<int>(below.size())};
}

}
