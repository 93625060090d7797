#pragma once

#include "host/preview/controls/help_pages.hpp"
#include "host/preview/controls/preview_key.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace kfast {

/// Which page of the help is seen while it is open, and the key that turns them.
class OpenHelp {
public:
    /// `rows` are those of help_pages().
    explicit OpenHelp(std::vector<std::string> rows) : rows_{std::move(rows)} {}

    /// The page to be seen on a grid of so many cells.
    HelpPage page(Size max)
    {
        auto pages = help_pages(rows_, max);
        count_ = pages.size();
        seen_ = std::min(seen_, count_ - 1);
        return std::move(pages[seen_]);
    }
    /// Whether `key` has turned a page of a help that is open, as it was seen last, and means nothing else.
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
