#pragma once

#include "host/text/diagnostic.hpp"

#include <cstddef>
#include <string>
#include <string_view>

/// Code points, white space and errors: what all parts of the parser read a text with.
namespace kfast::kdl {

/// White space that does not end a line.
bool is_space(char32_t point);

/// CR and LF count one by one here; that CR LF is one new line is up to the reader.
bool is_newline(char32_t point);

/// Allowed nowhere in a document, except U+FEFF as its very first code point.
bool is_disallowed(char32_t point);

/// Allowed in a string without quotes. Other rules limit how such a string begins. Says nothing about
/// disallowed code points: they are errors of their own, wherever they are.
bool is_identifier_character(char32_t point);

/// Walks through a text of valid UTF-8 and reports what is wrong with it.
///
/// After an error the rest of the node follows from guesses. The scanner therefore falls silent with each
/// error until silence(false) says that parsing is in step again.
class Scanner {
public:
    /// What peek() answers at the end; no code point has this value.
    static constexpr char32_t end_of_text = 0xFFFF'FFFF;

    /// Both must outlive the scanner.
    Scanner(std::string_view text, Diagnostics& diagnostics) : text_(text), diagnostics_(diagnostics) {}

    std::string_view text() const { return text_; }
    std::size_t offset() const { return offset_; }
    bool at_end() const { return offset_ == text_.size(); }
    bool at(std::string_view expected) const { return text_.substr(offset_).starts_with(expected); }
    bool at_newline() const;
    bool at_space() const;
    char32_t peek() const;

    std::string_view since(std::size_t begin) const { return text_.substr(begin, offset_ - begin); }
    SourceSpan place_since(std::size_t begin) const { return {.offset = begin, .length = offset_ - begin}; }

    /// Goes over one code point. Not at the end.
    void advance();
    /// Goes over `expected` if that comes next.
    bool accept(std::string_view expected);
    /// Goes over one new line, which may be CR LF, if that comes next.
    bool accept_newline();

    void error(SourceSpan place, std::string message, std::string hint = {});
    void warning(SourceSpan place, std::string message, std::string hint = {});
    /// Returns whether it was silent.
    bool silence(bool silent);
    /// Nothing after this is read or reported.
    void stop();

private:
    void report(SourceSpan place, std::string message, std::string hint);

    std::string_view text_;
    Diagnostics& diagnostics_;
    std::size_t offset_ = 0;
    std::size_t last_error_ = 0;
    int errors_ = 0;
    bool silent_ = false;
    bool stopped_ = false;
};

/// Goes over white space within a node: spaces, /* comments */ and line continuations.
void skip_node_space(Scanner& scanner);

/// Goes over white space between nodes: the above, new lines and // comments.
void skip_line_space(Scanner& scanner);

/// Goes over spaces alone.
void skip_spaces(Scanner& scanner);

/// Reports what no document may hold: bytes that are not UTF-8, and disallowed code points.
///
/// Of the former only the first, and then returns false: the text cannot be parsed. Skips no text but a byte
/// order mark at the beginning.
bool check_encoding(Scanner& scanner);

}
