#pragma once

#include "core/math/point.hpp"
#include "host/preview/controls/preview_key.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kfast {

/// A line of help on a grid of characters, (0, 0) at the left upper corner.
struct HelpLine {
    int column = 0;
    int row = 0;
    std::string text;
    int key_columns = 0; ///< the length of the name of a key at its beginning; 0 where a line continues
};

struct HelpPage {
    Size cells; ///< the size of the lines
    std::vector<HelpLine> lines;
};

/// Keys and what they do, in as few columns as they fit in, and on several pages where that is not enough.
///
/// `rows` begin with the name of a key, then at least one space. Long ones are wrapped. No line leaves a grid
/// of `max` cells, each side of which counts as 1 at least. There is at least one page; of several, each
/// says at its end which it is and that `h` changes the page.
std::vector<HelpPage> help_pages(std::span<const std::string> rows, Size max);

/// Which page of the help is visible while it is open, and the key that changes it.
class OpenHelp {
public:
    /// `rows` are those of help_pages().
    explicit OpenHelp(std::vector<std::string> rows) : rows_{std::move(rows)} {}

    /// The page to be shown on a grid of `max` cells.
    HelpPage page(Size max)
    {
        auto pages = help_pages(rows_, max);
        count_ = pages.size();
        seen_ = std::min(seen_, count_ - 1);
        return std::move(pages[seen_]);
    }
    /// Whether `key` has changed the page of an open help, as it was seen last, and means nothing else.
    bool turns(PreviewKey key, bool is_open)
    {
        const bool does_turn = is_open && key == PreviewKey::help && seen_ + 1 < count_;
        seen_ = does_turn ? seen_ + 1 : 0;
        return does_turn;
    }

private:
    std::vector<std::string> rows_;
    std::size_t seen_ = 0;
    std::size_t count_ = 1;
};

}
