#pragma once

#include <optional>
#include <string>

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
    /// Of the line that the kernel calls so.
    std::optional<unsigned> offset_of(const std::string& line) const;
    /// Who has the line, in the kernel's words; empty: nobody. `offset` is less than line_count().
    std::string user_of(unsigned offset) const;

    gpiod_chip* get() const { return chip_; }

private:
    gpiod_chip* chip_;
};

}
