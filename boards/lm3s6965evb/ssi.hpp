#pragma once

#include <cstddef>
#include <span>

namespace kfast::lm3s6965evb {

/// The display's bus: SSI0 at 3.57 MHz, D/C on PC7. Pixels are fed by interrupt, four bytes at a time.
class Ssi {
public:
    void begin();
    void command(std::span<const std::byte> bytes);
    void parameters(std::span<const std::byte> bytes);
    void start_data(std::span<const std::byte> bytes);
    bool busy() const;
};

}
