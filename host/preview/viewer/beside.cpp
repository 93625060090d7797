#include "host/preview/viewer/beside.hpp"

#include "host/picture/picture.hpp"
#include "host/preview/files/panel_pictures.hpp"
#include "host/preview/painter/painter.hpp"
#include "host/preview/painter/text_columns.hpp"
#include "host/preview/panes/theme.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace kfast {
namespace {

int gap_of(const Picture& left) { return std::max(4, left.size.width / 16); }

std::string comparison(const Picture& here, const Picture& there)
{
    const auto differing =
        std::transform_reduce(here.pixels.begin(), here.pixels.end(), there.pixels.begin(), std::size_t{0},
                              std::plus{}, [](Colour a, Colour b) { return std::size_t{a == b ? 0U : 1U}; });
    if (differing == 0)
        return "board: the same picture";
    return "board: " + counted(differing, "pixel") + (differing == 1 ? " differs" : " differ");
}

}

std::optional<Beside> beside(Viewer& viewer)
{
    const PanelPictures* const pictures = viewer.scene().beside.get();
    if (pictures == nullptr)
        return std::nullopt;
    const Picture& there = pictures->at(viewer.playback().frame());
    return Beside{there, comparison(widen(viewer.frame()), there)};
}

Picture joined(const Picture& left, const Picture& right)
{
    const int gap = gap_of(left);
    Picture both =
        plain_picture(left.size.width + gap + right.size.width, std::max(left.size.height, right.size.height),
                      theme::backdrop, "both pictures");
    put(left, both, 0, 0);
    put(right, both, left.size.width + gap, 0);
    return both;
}

int right_column(const Picture& left, const Picture& right, int columns)
{
    const int begin = left.size.width + gap_of(left);
    return begin * columns / (begin + right.size.width);
}

void draw_caption(Painter& painter, Rect pane, const std::string& text)
{
    constexpr int margin = 4;
    const Clipped within{painter, pane};
    const int width = columns_of(text) * Painter::letter.width;
    const int x = pane.x + (pane.width - width) / 2;
    const int y = bottom_of(pane) - Painter::letter.height - 2 * margin;
    painter.fill({x - margin, y - margin / 2, width + 2 * margin, Painter::letter.height + margin},
                 theme::shade);
    painter.text(x, y, text, theme::text);
}

}
