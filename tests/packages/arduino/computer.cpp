// Runs a sketch on a computer: its program writes the glass, after each of so many steps of 0.1 s, to its
// output.
#include "tests/packages/arduino/glass.h"

#include <Arduino.h>
#include <cstdio>
#include <cstdlib>

SerialPort Serial;

namespace {

constexpr int first_pressed = 4, last_pressed = 6;
uint16_t glass[glass_side][glass_side];
int step = 0;

}

unsigned long millis()
{
    return 0xFFFFFF00u + 100u * static_cast<unsigned>(step); // 32 bits on a chip: it runs over
}

void pinMode(int, int) {}

int digitalRead(int) { return step >= first_pressed && step <= last_pressed ? LOW : HIGH; }

void SerialPort::println(const char* text) { std::fprintf(stderr, "%d %s\n", step, text); }

void put_on_glass(int x, int y, int width, int height, const uint16_t* pixels, bool swapped)
{
    for (int row = y; row < y + height; ++row)
        for (int column = x; column < x + width; ++column, ++pixels)
            glass[row][column] = swapped ? static_cast<uint16_t>(*pixels << 8 | *pixels >> 8) : *pixels;
}

int main(int, char** arguments)
{
    setup();
    for (; step < std::atoi(arguments[1]); ++step) {
        loop();
        loop(); // it is called more often than pictures change
        std::fwrite(glass, sizeof glass, 1, stdout);
    }
}
