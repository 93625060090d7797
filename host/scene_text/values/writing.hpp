#pragma once

#include "host/art/budget.hpp"
#include "host/art/losses.hpp"
#include "host/scene_text/values/colours.hpp"
#include "host/scene_text/values/names.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace kfast::scene_text {

/// A skeleton and its bones as the scene calls them.
struct RigNames {
    std::string rig;
    std::vector<std::string> bones;
};

/// What is known of the scene while its nodes are written.
struct Writing {
    Writing(std::int32_t ticks, art::Losses& reported, art::Budget& computed)
        : length{ticks}, losses{reported}, budget{computed}, colours{reported}
    {
    }

    std::int32_t length; ///< ticks
    art::Losses& losses;
    art::Budget& budget;
    Colours colours;
    Names object_names = {};
    std::vector<RigNames> rigs = {};
};

}
