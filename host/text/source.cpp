#include "host/text/source.hpp"

#include "host/text/characters.hpp"

#include <algorithm>
#include <iterator>

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

namespace {

constexpr std::size_t between_marks = 256;

}

Places::Places(std::string_view text) : text_{text}
{
    Position position;
    marks_.push_back(position);
    while (position.offset < text.size()) {
        position = behind(position);
        if (position.offset >= marks_.back().offset + between_marks)
            marks_.push_back(position);
    }
}

/// Behind the code point that begins there.
Places::Position Places::behind(Position position) const
{
    const CodePoint point = code_point_at(text_, position.offset);
    position.offset += point.length;
    if (line_ends_before(text_, position.offset))
        return {position.offset, {position.place.line + 1, 1}, 0};
    ++position.place.column;
    position.code_units += point.value > 0xFFFF ? 2 : 1;
    return position;
}

/// Of the code point that contains `offset`.
Places::Position Places::at(std::size_t offset) const
{
    offset = std::min(offset, text_.size());
    Position position = *std::prev(std::ranges::upper_bound(marks_, offset, {}, &Position::offset));
    while (position.offset < offset) {
        const Position next = behind(position);
        if (next.offset > offset)
            break;
        position = next;
    }
    return position;
}

std::string_view line_at(std::string_view text, std::size_t offset)
{
    offset = std::min(offset, text.size());
    const std::size_t begin = line_begin(text, offset);
    return text.substr(begin, text.find_first_of(line_ends, begin) - begin);
}

namespace {

constexpr std::size_t room_for_line = 120;
constexpr std::size_t room_before_place = 60; // when the line is too long to be shown whole

std::size_t columns(std::string_view text)
{
    std::size_t sum = 0;
    for (std::size_t at = 0; at < text.size(); at += code_point_at(text, at).length)
        sum += glyph(code_point_at(text, at)).columns;
    return sum;
}

/// The columns that a code point uses up. Unlike its width this is never 0, so that a long run of combining
/// marks is cut as well.
std::size_t room(CodePoint point) { return std::max<std::size_t>(glyph(point).columns, 1); }

/// The longest prefix of `text` that fits.
std::string_view beginning(std::string_view text, std::size_t room_left)
{
    std::size_t at = 0;
    while (at < text.size() && room(code_point_at(text, at)) <= room_left) {
        room_left -= room(code_point_at(text, at));
        at += code_point_at(text, at).length;
    }
    return text.substr(0, at);
}

/// A suffix of `text` that fits. Looks at the last few bytes only, for a line may be a whole file.
std::string_view ending(std::string_view text, std::size_t room_left)
{
    constexpr std::size_t longest_sequence = 4;
    std::string_view end = text.substr(text.size() - std::min(text.size(), longest_sequence * room_left));
    while (!end.empty() && continues_sequence(end.front()))
        end.remove_prefix(1);
    while (beginning(end, room_left).size() < end.size())
        end.remove_prefix(code_point_at(end, 0).length);
    return end;
}

/// Both parts of a line that is split where the span begins.
struct Halves {
    std::string_view before;
    std::string_view from;
};

bool fits(std::string_view text) { return beginning(text, room_for_line).size() == text.size(); }

Halves cut(std::string_view line, std::size_t split)
{
    const Halves whole{.before = line.substr(0, split), .from = line.substr(split)};
    if (fits(line))
        return whole;
    const std::string_view before = ending(whole.before, room_before_place);
    return {.before = before, .from = beginning(whole.from, room_for_line - columns(before))};
}

std::string marks_under(std::string_view marked)
{
    return '^' + std::string(std::max<std::size_t>(columns(marked), 1) - 1, '~');
}

}

Excerpt excerpt(std::string_view text, SourceSpan place)
{
    const std::string_view line = line_at(text, place.offset);
    const auto line_offset = static_cast<std::size_t>(line.data() - text.data());
    const std::size_t split = std::min(std::min(place.offset, text.size()) - line_offset, line.size());
    const auto [before, from] = cut(line, split);

    const bool cut_before = before.size() < split;
    const bool cut_after = split + from.size() < line.size();
    const std::size_t indent = columns(before) + (cut_before ? 1 : 0);
    return {.line = (cut_before ? "…" : "") + visible(before) + visible(from) + (cut_after ? "…" : ""),
            .marks = std::string(indent, ' ') + marks_under(from.substr(0, place.length))};
}

}
