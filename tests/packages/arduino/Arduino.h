// As much of an Arduino core as the sketches of examples/arduino use.
#pragma once

#include <stddef.h>
#include <stdint.h>

constexpr int LOW = 0;
constexpr int HIGH = 1;
constexpr int INPUT_PULLUP = 2;

unsigned long millis();
void pinMode(int pin, int mode);
int digitalRead(int pin);

struct SerialPort {
    void begin(unsigned long) {}
    void println(const char* text);
};
extern SerialPort Serial;

void setup();
void loop();
