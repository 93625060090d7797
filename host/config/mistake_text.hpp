#pragma once

#include "firmware/settings/board_rules.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kfast::config {

/// What is wrong with settings, and what would be right.
struct Finding {
    std::string message;
    std::string hint;
};

/// The first mistake against each of the rules.
std::vector<SettingsMistake> mistakes(const BoardSettings& settings);

/// A mistake of these settings in words.
Finding text_of(const SettingsMistake& mistake, const BoardSettings& settings);

/// Hz that the maker of the display controller allows for writing on this bus; 0: not this bus.
std::uint32_t rated_clock(const BoardSettings& settings);

/// If the bus is faster than the display controller is rated for: no mistake, because many tolerate it.
std::optional<Finding> clock_warning(const BoardSettings& settings);

}
