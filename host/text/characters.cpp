#include "host/text/characters.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace kfast {

namespace {

void append_byte(std::string& text, char32_t byte) { text += static_cast<char>(byte); }

}

void append_utf8(std::string& text, char32_t value)
{
    if (value < 0x80)
        return append_byte(text, value);
    if (value < 0x800) {
        append_byte(text, 0xC0 | value >> 6);
    } else if (value < 0x10000) {
        append_byte(text, 0xE0 | value >> 12);
        append_byte(text, 0x80 | (value >> 6 & 0x3F));
    } else {
        append_byte(text, 0xF0 | value >> 18);
        append_byte(text, 0x80 | (value >> 12 & 0x3F));
        append_byte(text, 0x80 | (value >> 6 & 0x3F));
    }
    append_byte(text, 0x80 | (value & 0x3F));
}

namespace {

bool has_mark(std::string_view text) { return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"); }

bool begins_a_text(char character)
{
    return (character >= ' ' && character <= '~') || character == '\t' || character == '\n' ||
           character == '\r';
}

}

char first_of_utf16(std::string_view text)
{
    if (has_mark(text))
        text.remove_prefix(2);
    if (text.size() < 2 || (text[0] == '\0') == (text[1] == '\0'))
        return '\0';
    const char character = text[0] == '\0' ? text[1] : text[0];
    return begins_a_text(character) ? character : '\0';
}

bool seems_utf16(std::string_view text) { return has_mark(text) || first_of_utf16(text) != '\0'; }

namespace {

struct Range {
    char32_t first;
    char32_t last;
};

constexpr std::array unprintable{
    Range{0x00, 0x1F},     Range{0x7F, 0x9F},     Range{0x061C, 0x061C}, Range{0x200B, 0x200F},
    Range{0x2028, 0x202E}, Range{0x2060, 0x206F}, Range{0xFEFF, 0xFEFF}, Range{0xFFF9, 0xFFFB},
};

// The blocks that terminals commonly draw over the previous glyph, or two columns wide; not every code point.
constexpr std::array combining{Range{0x0300, 0x036F}, Range{0x20D0, 0x20FF}, Range{0xFE00, 0xFE0F}};
constexpr std::array wide{
    Range{0x1100, 0x115F},   Range{0x2E80, 0xA4CF},   Range{0xAC00, 0xD7A3},   Range{0xF900, 0xFAFF},
    Range{0xFE30, 0xFE6F},   Range{0xFF00, 0xFF60},   Range{0xFFE0, 0xFFE6},   Range{0x1F300, 0x1F64F},
    Range{0x1F680, 0x1F6FF}, Range{0x1F900, 0x1F9FF}, Range{0x20000, 0x3FFFD},
};

bool is_in(const auto& ranges, char32_t value)
{
    return std::ranges::any_of(ranges, [=](Range r) { return r.first <= value && value <= r.last; });
}

std::string code_of(const char* pattern, char32_t value)
{
    std::array<char, 16> code{};
    std::snprintf(code.data(), code.size(), pattern, static_cast<unsigned>(value));
    return code.data();
}

Glyph as_code(const char* pattern, char32_t value)
{
    std::string code = code_of(pattern, value);
    const std::size_t columns = code.size();
    return {.text = std::move(code), .columns = columns};
}

std::size_t columns(char32_t value)
{
    if (is_in(combining, value))
        return 0;
    return is_in(wide, value) ? 2 : 1;
}

}

bool is_printable(char32_t value) { return !is_in(unprintable, value); }

Glyph glyph(CodePoint point)
{
    if (!point.valid)
        return as_code("<0x%02X>", point.value);
    if (point.value == '\t')
        return {.text = "    ", .columns = 4};
    if (!is_printable(point.value))
        return as_code("<U+%04X>", point.value);
    Glyph printable{.text = {}, .columns = columns(point.value)};
    append_utf8(printable.text, point.value);
    return printable;
}

std::string visible(std::string_view text)
{
    std::string shown;
    for (std::size_t at = 0; at < text.size(); at += code_point_at(text, at).length)
        shown += glyph(code_point_at(text, at)).text;
    return shown;
}

std::string printable_json(std::string_view json)
{
    std::string text;
    for (std::size_t at = 0; at < json.size();) {
        const CodePoint point = code_point_at(json, at);
        if (point.value == '\n' || is_printable(point.value))
            text += json.substr(at, point.length);
        else
            text += code_of("\\u%04x", point.value); // none is above U+FFFF
        at += point.length;
    }
    return text;
}

std::string in_quotes(std::string_view text)
{
    constexpr std::size_t longest = 40;
    std::size_t end = 0;
    for (std::size_t count = 0; end < text.size() && count < longest; ++count)
        end += code_point_at(text, end).length;
    return '"' + visible(text.substr(0, end)) + (end < text.size() ? "…\"" : "\"");
}

}
