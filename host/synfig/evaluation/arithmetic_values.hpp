#pragma once

#include "host/synfig/evaluation/evaluator.hpp"

namespace kfast::synfig {

/// Of sums, products and other functions of numbers.
ValueLaws arithmetic_laws();

/// To the nearest whole number, halves up.
Value rounded(const Value& value);

}
