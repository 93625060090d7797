#pragma once

#include <Adafruit_GFX.h>

class Adafruit_ST7789 : public Adafruit_GFX {
public:
    Adafruit_ST7789(int8_t, int8_t, int8_t) {}
    void init(uint16_t, uint16_t) {}
};
