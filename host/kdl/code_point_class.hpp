#pragma once

/// The classes of code points that KDL's grammar names.
namespace kfast::kdl {

/// White space that does not end a line.
bool is_space(char32_t point);

/// CR and LF count one by one here; that CR LF is one new line is up to the reader.
bool is_newline(char32_t point);

/// May stand nowhere in a document, except U+FEFF as its very first code point.
bool is_disallowed(char32_t point);

/// May stand in a string without quotes. Other rules limit how such a string begins. Says nothing about
/// disallowed code points: they are errors of their own, wherever they stand.
bool is_identifier_character(char32_t point);

}
