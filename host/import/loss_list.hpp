#pragma once

#include "host/art/losses.hpp"

#include <cstdint>
#include <string>

namespace kfast::importing {

/// "1 thing is not carried over", "3 things are not carried over".
std::string loss_count(const art::Losses& losses);

enum class ListLength : std::uint8_t {
    cut, ///< to what fits on a screen, and how much more there is
    whole,
};

/// Lines for a terminal, without the last line end: what is lost in the same way is listed together.
std::string loss_list(const art::Losses& losses, ListLength length);

}
