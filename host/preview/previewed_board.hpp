#pragma once

#include "host/fit/target.hpp"
#include "host/preview/stage.hpp"

namespace kfast {

/// The board that a preview judges by: a Raspberry Pi Pico with the panel of the stage, an ST7789 of that
/// size if none is named; or with a beam.
fit::Target previewed_board(const Stage& stage);

}
