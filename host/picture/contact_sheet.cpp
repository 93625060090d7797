#include "host/picture/contact_sheet.hpp"

#include "host/picture/digit_picture.hpp"
#include "host/picture/picture_part.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr int gap = 4;
constexpr Colour paper{48, 48, 48};
constexpr Colour ink{224, 224, 224};

Size cell_size(const std::vector<ContactPrint>& prints)
{
    Size cell{0, prints.front().picture.size.height + gap + digit_cell.height};
    for (const ContactPrint& print : prints)
        cell.width = std::max(
            {cell.width, print.picture.size.width, static_cast<int>(print.label.size()) * digit_cell.width});
    return cell;
}

int column_count(std::size_t prints)
{
    int columns = 1;
    while (static_cast<std::size_t>(columns) * static_cast<std::size_t>(columns) < prints)
        ++columns;
    return columns;
}

}

Picture contact_sheet(const std::vector<ContactPrint>& prints)
{
    const Size cell = cell_size(prints);
    const int columns = column_count(prints.size());
    const int count = static_cast<int>(prints.size());
    const int rows = (count + columns - 1) / columns;
    Picture sheet = plain_picture(gap + std::int64_t{columns} * (cell.width + gap),
                                  gap + std::int64_t{rows} * (cell.height + gap), paper, "the contact sheet");
    for (int number = 0; number < count; ++number) {
        const ContactPrint& print = prints[static_cast<std::size_t>(number)];
        const int x = gap + number % columns * (cell.width + gap);
        const int y = gap + number / columns * (cell.height + gap);
        put(print.picture, sheet, x, y);
        put(digit_picture(print.label, ink, paper), sheet, x, y + print.picture.size.height + gap);
    }
    return sheet;
}

}
