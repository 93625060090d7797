#pragma once

#include "host/synfig/evaluation/value_law.hpp"

namespace kfast::synfig {

/// Of bones, and what they carry.
ValueLaws bone_laws();

}
