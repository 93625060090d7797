#include "host/picture/contact_sheet.hpp"

#include "host/picture/picture.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace kfast {

namespace {

/// Pixels from one character to the next, and from the top to the bottom of one.
inline constexpr Size digit_cell{6, 7};

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

/// Digits, points, spaces and "s" (for seconds), the rest as spaces, in plain pixels; one character at least.
Picture digit_picture(std::string_view text, Colour colour, Colour behind)
{
    Picture picture{{static_cast<int>(text.size()) * digit_cell.width, digit_cell.height}, {}};
    for (int y = 0; y < digit_cell.height; ++y)
        for (const char character : text)
            for (int x = 0; x < digit_cell.width; ++x)
                picture.pixels.push_back(is_set(character, x, y) ? colour : behind);
    return picture;
}

constexpr int gap = 4;
constexpr Colour paper{48, 48, 48};
constexpr Colour ink{224, 224, 224};

Size cell_size(Size picture, std::size_t longest_label)
{
    return {std::max(picture.width, static_cast<int>(longest_label) * digit_cell.width),
            picture.height + gap + digit_cell.height};
}

/// As many as fit beside each other.
int room_for(int side, int scale)
{
    return static_cast<int>((longest_picture_side / scale - gap) / (side + gap));
}

int column_count(int prints)
{
    int columns = 1;
    while (columns * columns < prints)
        ++columns;
    return columns;
}

bool is_possible(Size sheet, int scale)
{
    const std::int64_t pixels = std::int64_t{sheet.width} * sheet.height * scale * scale;
    return std::max(sheet.width, sheet.height) * std::int64_t{scale} <= longest_picture_side &&
           pixels <= max_picture_pixels;
}

}

Size ContactLayout::sheet() const
{
    const int rows = (static_cast<int>(count) + columns - 1) / columns;
    return {gap + columns * (cell.width + gap), gap + rows * (cell.height + gap)};
}

std::optional<ContactLayout> contact_layout(std::size_t count, Size picture, std::size_t longest_label,
                                            int scale)
{
    constexpr std::size_t max_prints = 1 << 20;
    if (count > max_prints)
        return std::nullopt;
    const int prints = static_cast<int>(count);
    const Size cell = cell_size(picture, longest_label);
    const int rows = std::max(room_for(cell.height, scale), 1);
    const int needed = (prints + rows - 1) / rows;
    const int columns = std::max(std::min(column_count(prints), room_for(cell.width, scale)), needed);
    const ContactLayout layout{count, columns, cell};
    return is_possible(layout.sheet(), scale) ? std::optional{layout} : std::nullopt;
}

Picture contact_sheet(const std::vector<ContactPrint>& prints, const ContactLayout& layout)
{
    const Size size = layout.sheet();
    Picture sheet = plain_picture(size.width, size.height, paper, "the contact sheet");
    for (int number = 0; number < static_cast<int>(prints.size()); ++number) {
        const ContactPrint& print = prints[static_cast<std::size_t>(number)];
        const int x = gap + number % layout.columns * (layout.cell.width + gap);
        const int y = gap + number / layout.columns * (layout.cell.height + gap);
        put(print.picture, sheet, x, y);
        put(digit_picture(print.label, ink, paper), sheet, x, y + print.picture.size.height + gap);
    }
    return sheet;
}

}
