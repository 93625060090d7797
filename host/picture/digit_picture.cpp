#include "host/picture/digit_picture.hpp"

#include <array>
#include <string>

namespace kfast {
namespace {

struct Glyph {
    char character;
    std::array<std::string_view, 7> rows;
};

constexpr std::array glyphs{
    Glyph{'0', {" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### "}},
    Glyph{'1', {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    Glyph{'2', {" ### ", "#   #", "    #", "  ## ", " #   ", "#    ", "#####"}},
    Glyph{'3', {" ### ", "#   #", "    #", "  ## ", "    #", "#   #", " ### "}},
    Glyph{'4', {"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "}},
    Glyph{'5', {"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "}},
    Glyph{'6', {"  ## ", " #   ", "#    ", "#### ", "#   #", "#   #", " ### "}},
    Glyph{'7', {"#####", "    #", "   # ", "  #  ", "  #  ", " #   ", " #   "}},
    Glyph{'8', {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### "}},
    Glyph{'9', {" ### ", "#   #", "#   #", " ####", "    #", "   # ", " ##  "}},
    Glyph{'.', {"     ", "     ", "     ", "     ", "     ", " ##  ", " ##  "}},
    Glyph{'s', {"     ", "     ", " ####", "#    ", " ### ", "    #", "#### "}},
};

bool is_set(char character, int x, int y)
{
    for (const Glyph& glyph : glyphs)
        if (glyph.character == character && x < 5)
            return glyph.rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#';
    return false;
}

}

Picture digit_picture(std::string_view text, Colour colour, Colour behind)
{
    Picture picture{{static_cast<int>(text.size()) * digit_cell.width, digit_cell.height}, {}};
    for (int y = 0; y < digit_cell.height; ++y)
        for (const char character : text)
            for (int x = 0; x < digit_cell.width; ++x)
                picture.pixels.push_back(is_set(character, x, y) ? colour : behind);
    return picture;
}

}
