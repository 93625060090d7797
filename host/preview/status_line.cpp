#include "host/preview/status_line.hpp"

#include "host/preview/area.hpp"
#include "host/preview/text_columns.hpp"
#include "host/preview/theme.hpp"

namespace kfast {

void draw_status(Painter& painter, Rect pane, std::string_view text)
{
    constexpr int margin = 8;
    constexpr Size letter = Painter::letter;
    const Clipped within{painter, pane};
    painter.fill(pane, theme::backdrop);
    painter.fill({pane.x, pane.y, pane.width, 1}, theme::border);
    painter.text(pane.x + margin, pane.y + (pane.height - letter.height) / 2 + 1,
                 cut(text, (pane.width - 2 * margin) / letter.width), theme::quiet_text);
}

}
