#include "host/preview/panes/status_line.hpp"

#include "host/preview/painter/area.hpp"
#include "host/preview/painter/text_columns.hpp"
#include "host/preview/panes/theme.hpp"

namespace kfast {

void draw_status(Painter& painter, Rect pane, std::string_view text, std::string_view hint)
{
    constexpr int margin = 8;
    constexpr int gap = 2; // columns
    constexpr Size letter = Painter::letter;
    const Clipped within{painter, pane};
    painter.fill(pane, theme::backdrop);
    painter.fill({pane.x, pane.y, pane.width, 1}, theme::border);
    const int y = pane.y + (pane.height - letter.height) / 2 + 1;
    const int columns = (pane.width - 2 * margin) / letter.width;
    const int hint_columns = columns_of(hint);
    if (columns_of(text) + gap + hint_columns <= columns)
        painter.text(right_of(pane) - margin - hint_columns * letter.width, y, hint, theme::text);
    painter.text(pane.x + margin, y, cut(text, columns), theme::quiet_text);
}

}
