#pragma once

#include "host/compiler/match/measured_stroke.hpp"

namespace kfast {

/// `stroke`, its curves divided until, in each segment, the points at the same share of parameter and of
/// length are no more than 1/32 px apart, or it is shorter than 2 px.
MeasuredStroke made_even(const MeasuredStroke& stroke);

}
