#pragma once

#include "host/synfig/evaluation/evaluator.hpp"

#include <string_view>
#include <utility>
#include <vector>

namespace kfast::synfig {

/// What a value node is at a time, in seconds.
using ValueLaw = Value (*)(Evaluator&, const ValueNode&, double);

/// Laws by the names of the elements that have them.
using ValueLaws = std::vector<std::pair<std::string_view, ValueLaw>>;

}
