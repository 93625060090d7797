#pragma once

#include "tests/packages/arduino/glass.h"

class TFT_eSPI {
public:
    void init() {}
    void setSwapBytes(bool swap) { swaps_ = swap; }
    void pushImage(int32_t x, int32_t y, int32_t width, int32_t height, uint16_t* pixels)
    {
        put_on_glass(x, y, width, height, pixels, !swaps_);
    }

private:
    bool swaps_ = false;
};
