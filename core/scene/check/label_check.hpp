#pragma once

#include "core/scene/input_view.hpp"
#include "core/scene/label_view.hpp"

namespace kfast {

/// Whether a label of this input is what the format allows, but for the drawings that it refers to.
bool label_is_sound(const LabelView& label, const TextInput& text);

}
