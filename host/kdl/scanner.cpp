#include "host/kdl/scanner.hpp"

#include "host/text/characters.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace kfast::kdl {

namespace {

constexpr std::u32string_view spaces = U"\t \u00A0\u1680\u202F\u205F\u3000";
constexpr std::u32string_view newlines = U"\n\v\f\r\u0085\u2028\u2029";
constexpr std::u32string_view punctuation = U"\\/(){};[]\"#=";

bool is_within(char32_t point, char32_t first, char32_t last) { return first <= point && point <= last; }

bool is_control(char32_t point) { return point <= 0x08 || is_within(point, 0x0E, 0x1F) || point == 0x7F; }

bool is_direction_mark(char32_t point)
{
    return is_within(point, 0x200E, 0x200F) || is_within(point, 0x202A, 0x202E) ||
           is_within(point, 0x2066, 0x2069);
}

}

bool is_space(char32_t point)
{
    return spaces.find(point) != spaces.npos || is_within(point, 0x2000, 0x200A);
}

bool is_newline(char32_t point) { return newlines.find(point) != newlines.npos; }

bool is_disallowed(char32_t point)
{
    return is_control(point) || is_direction_mark(point) || is_within(point, 0xD800, 0xDFFF) ||
           point == 0xFEFF;
}

bool is_identifier_character(char32_t point)
{
    return point <= 0x10FFFF && punctuation.find(point) == punctuation.npos && !is_space(point) &&
           !is_newline(point);
}

namespace {

constexpr int max_errors = 20;

}

bool Scanner::at_newline() const { return is_newline(peek()); }

bool Scanner::at_space() const { return is_space(peek()); }

char32_t Scanner::peek() const { return at_end() ? end_of_text : code_point_at(text_, offset_).value; }

void Scanner::advance() { offset_ += code_point_at(text_, offset_).length; }

bool Scanner::accept(std::string_view expected)
{
    if (!at(expected))
        return false;
    offset_ += expected.size();
    return true;
}

bool Scanner::accept_newline()
{
    if (accept("\r\n"))
        return true;
    if (!at_newline())
        return false;
    advance();
    return true;
}

void Scanner::error(SourceSpan place, std::string message, std::string hint)
{
    if (silent_ || stopped_)
        return;
    silent_ = true;
    if (errors_ < max_errors)
        return report(place, std::move(message), std::move(hint));
    report({.offset = last_error_, .length = 0},
           "there are more than " + std::to_string(max_errors) + " errors; the rest is not shown", {});
    stop();
}

void Scanner::warning(SourceSpan place, std::string message, std::string hint)
{
    diagnostics_.warning(place, std::move(message), std::move(hint));
}

bool Scanner::silence(bool silent) { return std::exchange(silent_, silent); }

void Scanner::stop()
{
    offset_ = text_.size();
    stopped_ = true;
}

void Scanner::report(SourceSpan place, std::string message, std::string hint)
{
    ++errors_;
    last_error_ = std::max(last_error_, place.offset);
    diagnostics_.error(place, std::move(message), std::move(hint));
}

namespace {

void skip_to_line_end(Scanner& scanner)
{
    while (!scanner.at_end() && !scanner.at_newline())
        scanner.advance();
}

/// At /*. Comments nest, so that text with comments can be commented out.
void skip_block_comment(Scanner& scanner)
{
    const std::size_t begin = scanner.offset();
    std::size_t depth = 0;
    do {
        if (scanner.accept("/*")) {
            ++depth;
        } else if (scanner.accept("*/")) {
            --depth;
        } else if (!scanner.at_end()) {
            scanner.advance();
        } else {
            scanner.error({.offset = begin, .length = 2}, "this comment is not closed", "add a closing */");
            return scanner.stop();
        }
    } while (depth > 0);
}

bool accept_block_comment(Scanner& scanner)
{
    if (!scanner.at("/*"))
        return false;
    skip_block_comment(scanner);
    return true;
}

bool accept_space(Scanner& scanner)
{
    if (!scanner.at_space())
        return accept_block_comment(scanner);
    scanner.advance();
    return true;
}

bool accept_line_continuation(Scanner& scanner)
{
    const std::size_t begin = scanner.offset();
    if (!scanner.accept("\\"))
        return false;
    while (accept_space(scanner)) {
    }
    if (scanner.at("//"))
        skip_to_line_end(scanner);
    if (!scanner.accept_newline() && !scanner.at_end())
        scanner.error(
            {.offset = begin, .length = 1}, "more follows on the line after this \\",
            "a \\ joins two lines: put it at the end of its line, or use quotes for a text with a \\");
    return true;
}

bool accept_node_space(Scanner& scanner)
{
    return accept_space(scanner) || accept_line_continuation(scanner);
}

bool accept_line_comment(Scanner& scanner)
{
    if (!scanner.at("//"))
        return false;
    skip_to_line_end(scanner);
    return true;
}

}

void skip_node_space(Scanner& scanner)
{
    while (accept_node_space(scanner)) {
    }
}

void skip_line_space(Scanner& scanner)
{
    while (accept_node_space(scanner) || scanner.accept_newline() || accept_line_comment(scanner)) {
    }
}

void skip_spaces(Scanner& scanner)
{
    while (scanner.at_space())
        scanner.advance();
}

namespace {

void report_bad_byte(Scanner& scanner, std::size_t at)
{
    const std::string shown = visible(scanner.text().substr(at, 1));
    scanner.error({.offset = at, .length = 1}, "the byte " + shown + " is not UTF-8",
                  "save the text in the encoding UTF-8");
}

void report_disallowed(Scanner& scanner, std::size_t at, CodePoint point)
{
    const std::string shown = visible(scanner.text().substr(at, point.length));
    scanner.error({.offset = at, .length = point.length},
                  "the character " + shown + " may not stand in a text",
                  "remove it; in a string between quotes it can be written like \\u{7F}");
    scanner.silence(false);
}

}

bool check_encoding(Scanner& scanner)
{
    scanner.accept("\uFEFF");
    bool in_run = false; // a run of disallowed code points is one error
    for (std::size_t at = scanner.offset(); at < scanner.text().size();) {
        const CodePoint point = code_point_at(scanner.text(), at);
        if (!point.valid) {
            report_bad_byte(scanner, at);
            return false;
        }
        if (is_disallowed(point.value) && !in_run)
            report_disallowed(scanner, at, point);
        in_run = is_disallowed(point.value);
        at += point.length;
    }
    return true;
}

}
