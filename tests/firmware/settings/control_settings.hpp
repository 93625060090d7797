#pragma once

#include "firmware/settings/board_settings.hpp"

#include <algorithm>
#include <initializer_list>

namespace kfast::test {

/// Of a board that has these, else as usual.
inline BoardSettings settings_with(std::initializer_list<Control> controls)
{
    BoardSettings settings;
    std::ranges::copy(controls, settings.controls.begin());
    return settings;
}

}
