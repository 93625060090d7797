#pragma once

namespace kfast::test {

/// What stands behind a file descriptor.
class StandInFile {
public:
    virtual ~StandInFile() = default;
    /// 0, or what errno is to be.
    virtual int control(unsigned long request, void* argument) = 0;
};

/// Tells the descriptor of what was opened: `number` is one of the real kernel's, for nothing else.
void stand_behind(int number, StandInFile* file);

/// A descriptor of the real kernel that can stand for something.
int new_descriptor();

/// The device of that name (gpiochip0, spidev0.0), which its description says how to be.
StandInFile* gpio_chip(const char* name);
StandInFile* spi_device(const char* name);

}
