// Where the stubs of displays put pixels.
#pragma once

#include <stdint.h>

enum : int { glass_side = 240 };

/// Rows of `pixels`, as the display is sent them: each of them with its high byte first, or `swapped`.
void put_on_glass(int x, int y, int width, int height, const uint16_t* pixels, bool swapped);
