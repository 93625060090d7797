#pragma once

#include "tests/packages/arduino/glass.h"

class Adafruit_GFX {
public:
    void drawRGBBitmap(int16_t x, int16_t y, uint16_t* pixels, int16_t width, int16_t height)
    {
        put_on_glass(x, y, width, height, pixels, false);
    }
};
