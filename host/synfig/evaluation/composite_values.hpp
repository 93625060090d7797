#pragma once

#include "host/synfig/evaluation/evaluator.hpp"

namespace kfast::synfig {

/// Of values that are put together of others, or taken apart.
ValueLaws composite_laws();

/// Of lists, whose entries come and go.
ValueLaws list_laws();

}
