#pragma once

#include "tests/packages/arduino/glass.h"

namespace lgfx {

struct rgb565_t {
    uint16_t raw;
};

class LGFXBase {
public:
    void pushImage(int32_t x, int32_t y, int32_t width, int32_t height, const rgb565_t* pixels)
    {
        put_on_glass(x, y, width, height, &pixels->raw, false);
    }
};

}

struct M5Board {
    lgfx::LGFXBase Display;
    void begin() {}
};
static M5Board M5;
