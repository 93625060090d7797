#pragma once

#include "host/synfig/values/value.hpp"

namespace kfast::synfig {

/// Of a list of width points, sorted or not: the width in between, straight from one to the next;
/// `default_value` where there is none.
double width_at(const List& points, double position, double default_value);

}
