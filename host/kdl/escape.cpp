#include "host/kdl/escape.hpp"

#include "host/kdl/scanner.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>

namespace kfast::kdl {

namespace {

struct Escape {
    char letter;
    char meaning;
};

constexpr std::array escapes{
    Escape{'"', '"'},  Escape{'\\', '\\'}, Escape{'b', '\b'}, Escape{'f', '\f'},
    Escape{'n', '\n'}, Escape{'r', '\r'},  Escape{'t', '\t'}, Escape{'s', ' '},
};

void skip_white_space(Scanner& scanner)
{
    while (scanner.at_space() || scanner.at_newline())
        scanner.advance();
}

bool is_hex_digit(char32_t point)
{
    return (point >= '0' && point <= '9') || (point >= 'a' && point <= 'f') || (point >= 'A' && point <= 'F');
}

std::string_view read_hex_digits(Scanner& scanner)
{
    const std::size_t begin = scanner.offset();
    while (is_hex_digit(scanner.peek()))
        scanner.advance();
    return scanner.since(begin);
}

/// After the u of an escape that began at `begin`.
bool read_unicode_escape(Scanner& scanner, std::size_t begin, std::string& text)
{
    const bool opened = scanner.accept("{");
    const std::string_view digits = opened ? read_hex_digits(scanner) : std::string_view{};
    const bool closed = opened && scanner.accept("}");
    const SourceSpan place = scanner.place_since(begin);
    if (!closed || digits.empty() || digits.size() > 6) {
        scanner.error(place, "\\u needs one to six hexadecimal digits in braces", "write it like \\u{1F600}");
        return false;
    }
    std::uint32_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (!is_scalar_value(value)) {
        scanner.error(place, "there is no character " + std::string(scanner.since(begin)),
                      "use a value up to 10FFFF, but none from D800 to DFFF");
        return false;
    }
    append_utf8(text, value);
    return true;
}

bool read_letter_escape(Scanner& scanner, std::size_t begin, std::string& text)
{
    const auto escape = std::ranges::find_if(
        escapes, [&](Escape e) { return scanner.peek() == static_cast<unsigned char>(e.letter); });
    if (escape != escapes.end()) {
        scanner.advance();
        text += escape->meaning;
        return true;
    }
    if (scanner.at_end())
        return false; // the message that the string is not closed is better
    const std::size_t letter = scanner.offset();
    scanner.advance();
    const std::string shown = visible(scanner.since(letter));
    scanner.error(scanner.place_since(begin), "\\" + shown + " means nothing in a string",
                  shown == "/" ? "write / as it is" : "write \\\\ for a \\ in the text");
    return false;
}

/// Code points that are not allowed in a quoted string of one line and have no escape letter of their own.
bool needs_code(char32_t point, Unseen unseen)
{
    return is_newline(point) || is_disallowed(point) || (unseen == Unseen::as_codes && !is_printable(point));
}

void append_escaped(std::string& into, CodePoint point, Unseen unseen)
{
    const auto escape = std::ranges::find_if(escapes, [&](Escape e) {
        return e.letter != 's' && point.value == static_cast<unsigned char>(e.meaning);
    });
    if (escape != escapes.end()) {
        into += {'\\', escape->letter};
    } else if (needs_code(point.value, unseen)) {
        std::array<char, 16> code{};
        std::snprintf(code.data(), code.size(), "\\u{%x}", static_cast<unsigned>(point.value));
        into += code.data();
    } else {
        append_utf8(into, point.value);
    }
}

}

bool read_escape(Scanner& scanner, std::string& text)
{
    const std::size_t begin = scanner.offset();
    scanner.advance();
    if (scanner.at_space() || scanner.at_newline()) {
        skip_white_space(scanner);
        return true;
    }
    if (scanner.accept("u"))
        return read_unicode_escape(scanner, begin, text);
    return read_letter_escape(scanner, begin, text);
}

std::string escaped(std::string_view text, Unseen unseen)
{
    std::string result;
    for (std::size_t at = 0; at < text.size(); at += code_point_at(text, at).length)
        append_escaped(result, code_point_at(text, at), unseen);
    return result;
}

}
