#include "host/scene/font/hershey_font.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>

namespace kfast::scene {

namespace {

constexpr char32_t first_character = U' ';
constexpr char32_t last_character = U'~';
constexpr double baseline = 9; ///< the bottom of the capitals

double distance(char character) { return character - 'R'; }

[[noreturn]] void refuse() { throw Failure("the Hershey font is damaged: build kfast again"); }

/// Cuts a font file into columns; the ends of lines are in none.
class Columns {
public:
    explicit Columns(std::string_view jhf)
    {
        for (const char character : jhf)
            if (character != '\n' && character != '\r')
                text_ += character;
    }

    bool at_end() const { return offset_ == text_.size(); }

    std::string_view take(std::size_t count)
    {
        if (text_.size() - offset_ < count)
            refuse();
        const std::string_view columns = std::string_view{text_}.substr(offset_, count);
        offset_ += count;
        return columns;
    }

    std::size_t take_number(std::size_t count)
    {
        std::string_view columns = take(count);
        columns.remove_prefix(std::min(columns.find_first_not_of(' '), columns.size()));
        std::size_t number = 0;
        const char* const end = columns.data() + columns.size();
        const auto [stop, error] = std::from_chars(columns.data(), end, number);
        if (error != std::errc{} || stop != end)
            refuse();
        return number;
    }

private:
    std::string text_;
    std::size_t offset_ = 0;
};

/// Puts the pen down at the first of the pairs and lifts it at " R".
class Pen {
public:
    Pen(Letter& letter, double left) : letter_{letter}, left_{left} {}

    void go(std::string_view pair)
    {
        if (pair == " R") {
            down_ = false;
            return;
        }
        const Vec2 spot{distance(pair[0]) - left_, distance(pair[1]) - baseline};
        if (down_)
            letter_.outlines.back().curves.push_back(line_to(spot));
        else
            letter_.outlines.push_back({.from = spot, .curves = {}, .closed = false});
        down_ = true;
    }

private:
    Letter& letter_;
    double left_;
    bool down_ = false;
};

Letter read_letter(Columns& columns)
{
    columns.take_number(5); // useless here: many files have the same for all glyphs
    const std::size_t pairs = columns.take_number(3);
    const std::string_view ends = columns.take(2);
    Letter letter;
    letter.advance = distance(ends[1]) - distance(ends[0]);
    Pen pen{letter, distance(ends[0])};
    for (std::size_t i = 1; i < pairs; ++i)
        pen.go(columns.take(2));
    return letter;
}

}

HersheyFont::HersheyFont(std::string_view jhf)
{
    Columns columns{jhf};
    while (!columns.at_end())
        letters_.push_back(read_letter(columns));
}

const Letter* HersheyFont::letter(char32_t character)
{
    const bool known = character >= first_character && character <= last_character &&
                       character - first_character < letters_.size();
    return known ? &letters_[character - first_character] : nullptr;
}

}
