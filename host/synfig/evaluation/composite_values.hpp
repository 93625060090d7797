#pragma once

#include "host/synfig/evaluation/value_law.hpp"

namespace kfast::synfig {

/// Of values that are put together of others, or taken apart.
ValueLaws composite_laws();

}
