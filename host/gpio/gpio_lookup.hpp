#pragma once

#include "host/gpio/gpio_outputs.hpp"
#include "host/program/failure.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

struct gpiod_chip;
namespace kfast {

/// A GPIO chip of this computer. Each API of libgpiod has a file of its own with the members.
class GpioChip {
public:
    /// Throws std::system_error.
    explicit GpioChip(const std::string& path);
    ~GpioChip();
    GpioChip(GpioChip&& other) noexcept;
    GpioChip& operator=(GpioChip&&) = delete;

    std::string name() const;  ///< gpiochip0
    std::string label() const; ///< pinctrl-bcm2711
    unsigned line_count() const;
    /// The offset of the line that has this name in the kernel.
    std::optional<unsigned> offset_of(const std::string& line) const;
    /// Who uses the line, in the kernel's words; empty: nobody. `offset` is less than line_count().
    std::string user_of(unsigned offset) const;

    gpiod_chip* get() const { return chip_; }

private:
    gpiod_chip* chip_;
};

/// Lines and the chip that has them.
struct FoundLines {
    GpioChip chip;
    std::vector<unsigned> offsets; ///< in the order of the lines asked for; no two are the same
};

/// Finds lines as GpioOutputs does. Throws Failure.
FoundLines find_lines(const std::string& chip, std::span<const GpioLine> lines);

/// The failure that a chip cannot be opened; `error` is the errno.
Failure cannot_open_chip(const std::string& path, int error);

/// The failure that its lines cannot be requested.
Failure cannot_have_lines(const FoundLines& found, int error, GpioDrive drive);

/// The failure that lines that this program has cannot be set.
Failure cannot_set_lines(const std::string& chip, int error);

/// "gpiochip0 (pinctrl-bcm2711)"
std::string text_of(const GpioChip& chip);

}
