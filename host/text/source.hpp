#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// A range of bytes in a source text.
struct SourceSpan {
    std::size_t offset = 0;
    std::size_t length = 0;
};

/// A text and its name in messages (usually its file name).
struct SourceText {
    std::string name;
    std::string text;
    /// The folder in which files that the text names are looked for, "" for the current one. Nothing: it may
    /// name none.
    std::optional<std::string> folder = std::nullopt;
};

/// The position of a byte for a reader. Both count from 1; a column is a Unicode code point.
struct LineColumn {
    std::size_t line = 1;
    std::size_t column = 1;
};

/// Lines end with LF, CR LF or a lone CR, as editors count them. An offset beyond the end means the end.
LineColumn line_column(std::string_view text, std::size_t offset);

/// The same for many places in a text, which it goes through once: a place takes as long in a long text as in
/// a short one.
class Places {
public:
    /// `text` must outlive it.
    explicit Places(std::string_view text);

    LineColumn line_column(std::size_t offset) const { return at(offset).place; }
    /// In UTF-16, from 0, as the Language Server Protocol counts.
    std::size_t code_units(std::size_t offset) const { return at(offset).code_units; }

private:
    struct Position {
        std::size_t offset = 0;
        LineColumn place = {};
        std::size_t code_units = 0; ///< of the line before it
    };

    Position behind(Position position) const;
    Position at(std::size_t offset) const;

    std::string_view text_;
    std::vector<Position> marks_; ///< every few hundred bytes
};

/// The whole line that contains `offset`, without its end. An offset beyond the end means the end.
std::string_view line_at(std::string_view text, std::size_t offset);

/// The part of a line that is shown around a location, and the marks that go under it.
struct Excerpt {
    std::string line;
    std::string marks; ///< spaces, then ^~~~ under the location
};

/// At most about 120 columns of the line that contains `place`; what is cut is replaced by ….
Excerpt excerpt(std::string_view text, SourceSpan place);

}
