#pragma once

#include "core/time.hpp"
#include "host/scene/reading.hpp"

#include <string_view>

/// What keys that stand in the order of their times have in common.
namespace kfast::scene {

/// Where and when something is.
struct Moment {
    Time time;
    Place place;
};

/// Whether `at`, a `noun` such as "key", is later than `before`, and reports it if not.
bool comes_later(std::string_view noun, Moment before, Moment at, Reading& reading);

}
