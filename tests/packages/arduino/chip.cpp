// Lets a sketch be linked for a chip, to see how large it is: all of this costs next to nothing.
#include "tests/packages/arduino/glass.h"

#include <Arduino.h>

SerialPort Serial;

namespace {

volatile uint32_t port;

}

unsigned long millis() { return port; }

void pinMode(int, int) {}

int digitalRead(int) { return static_cast<int>(port); }

void SerialPort::println(const char* text) { port = static_cast<uint32_t>(*text); }

void put_on_glass(int, int, int, int, const uint16_t* pixels, bool) { port = *pixels; }

int main()
{
    setup();
    while (true)
        loop();
}
