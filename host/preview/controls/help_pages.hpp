#pragma once

#include "core/math/point.hpp"

#include <span>
#include <string>
#include <vector>

namespace kfast {

/// A line of help on a grid of characters, (0, 0) at the left upper corner.
struct HelpLine {
    int column = 0;
    int row = 0;
    std::string text;
    int key_columns = 0; ///< at its beginning, the name of a key; 0 where a line goes on
};

struct HelpPage {
    Size cells; ///< that the lines take
    std::vector<HelpLine> lines;
};

/// Keys and what they do, in as few columns as they fit in, and on several pages where that is not enough.
///
/// `rows` begin with the name of a key, then at least one space. Long ones are wrapped. No line leaves a grid
/// of `max` cells, each side of which counts as 1 at least. There is at least one page; of several, each
/// tells at its end which it is and that `h` turns it.
std::vector<HelpPage> help_pages(std::span<const std::string> rows, Size max);

}
