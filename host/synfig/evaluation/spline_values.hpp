#pragma once

#include "host/synfig/evaluation/evaluator.hpp"

namespace kfast::synfig {

/// Of places, directions and widths along splines.
ValueLaws spline_laws();

}
