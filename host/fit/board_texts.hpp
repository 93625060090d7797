#pragma once

#include <span>
#include <string_view>

namespace kfast::fit {

/// The description of a board that is part of this program: a file of host/fit/boards.
struct BoardText {
    std::string_view name;
    std::string_view text;
};

std::span<const BoardText> board_texts();

}
