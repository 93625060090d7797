#pragma once

#include "firmware/settings/board_settings.hpp"

#include <random>

namespace kfast::test {

/// Settings that keep all rules of firmware/settings/board_rules.hpp, controls without gaps; all that can be
/// are likely to come.
BoardSettings random_settings(std::mt19937& random);

}
