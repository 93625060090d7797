#pragma once

#include "host/synfig/evaluation/value_law.hpp"

namespace kfast::synfig {

/// Of lists, whose entries come and go.
ValueLaws list_laws();

}
