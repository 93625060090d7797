#pragma once

#include "host/synfig/evaluation/evaluator.hpp"

namespace kfast::synfig {

/// Of bones, and what they carry.
ValueLaws bone_laws();

}
