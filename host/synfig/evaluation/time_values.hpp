#pragma once

#include "host/synfig/evaluation/value_law.hpp"

namespace kfast::synfig {

/// Of values that go by another time.
ValueLaws time_laws();

}
