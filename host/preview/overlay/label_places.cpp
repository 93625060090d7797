#include "host/preview/overlay/label_places.hpp"

#include "host/preview/painter/painter.hpp"

#include <cmath>

namespace kfast {

bool LabelPlaces::take(PanelSpot at, const std::string& text)
{
    if (count_ == max)
        return false;
    // A text takes the cells that it touches: one more than it has letters, in two rows.
    const int column = static_cast<int>(std::floor(at.x * scale_ / Painter::letter.width));
    const int row = static_cast<int>(std::floor(at.y * scale_ / Painter::letter.height));
    const int end = column + static_cast<int>(text.size()) + 1;
    for (int x = column; x < end; ++x)
        for (int y = row; y < row + 2; ++y)
            if (cells_.contains({x, y}))
                return false;
    for (int x = column; x < end; ++x)
        for (int y = row; y < row + 2; ++y)
            cells_.emplace(x, y);
    ++count_;
    return true;
}

}
