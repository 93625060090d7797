#include "host/commands/text/glyph_text.hpp"

#include "host/text/characters.hpp"

namespace kfast {
namespace {

/// Digits, capitals, small letters of ASCII, and all others: ranges are read more easily within them.
int kind_of(char32_t character)
{
    const auto is_in = [character](char32_t first, char32_t last) {
        return character >= first && character <= last;
    };
    return is_in(U'0', U'9') ? 1 : is_in(U'A', U'Z') ? 2 : is_in(U'a', U'z') ? 3 : 0;
}

/// The characters `first` … `last` in as few letters as possible; a "-" that would be mistaken for that of a
/// range goes to `end`.
void append_stretch(std::string& text, char32_t first, char32_t last, std::string& end)
{
    if (first == U'-') {
        end = "-";
        ++first;
    }
    if (last >= first + 2) {
        append_utf8(text, first);
        text += '-';
        append_utf8(text, last);
        return;
    }
    for (; first <= last; ++first) {
        if (first == U'-')
            end = "-";
        else
            append_utf8(text, first);
    }
}

}

std::string glyph_text(const GlyphSet& glyphs)
{
    std::string text;
    std::string end;
    for (std::uint32_t glyph = 0; glyph < glyphs.count();) {
        char32_t first = glyphs.character(glyph);
        char32_t last = first;
        while (++glyph < glyphs.count() && glyphs.character(glyph) == last + 1 &&
               kind_of(last) == kind_of(last + 1))
            ++last;
        if (first == U' ' && first++ == last)
            continue;
        append_stretch(text, first, last, end);
    }
    return text + end;
}

}
