#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace kfast {

enum class GpioDrive {
    push_pull,
    open_drain, ///< high is not driven
};

/// A line of a GPIO chip that this program is to drive.
struct GpioLine {
    std::string name;   ///< what the kernel calls it ("GPIO25"), or its offset in the chip ("25")
    bool level = false; ///< at first
};

/// Lines of one GPIO chip of a Linux computer, which no other program can have meanwhile. When it ends, they
/// are free. A driver leaves free lines as they were, as in Raspberry Pi OS, or makes them inputs, as in
/// other kernels (raspberrypi/linux, pull request 6117).
///
/// Through libgpiod, whichever of its APIs the build has found: 1.6 or 2.
class GpioOutputs {
public:
    static constexpr std::size_t max_lines = 32;

    /// `chip` is a path (/dev/gpiochip0), a name (gpiochip0) or a label (pinctrl-bcm2711); empty: the first
    /// chip that has a line of the first name, or the only chip that there is if it is an offset.
    ///
    /// Throws Failure: with no_device if there is no such chip or line; with no_permission; with refused if
    /// another program has a line, or the chip cannot drive it that way.
    GpioOutputs(const std::string& chip, std::span<const GpioLine> lines,
                GpioDrive drive = GpioDrive::push_pull);
    ~GpioOutputs();
    GpioOutputs(GpioOutputs&&) noexcept;
    GpioOutputs& operator=(GpioOutputs&&) noexcept;

    /// Bit i of both is for line i: the lines in `which` are set to their bits of `levels`, in one call of
    /// the kernel where its API has one. Throws Failure with unplugged if the chip is gone.
    void set(std::uint32_t which, std::uint32_t levels);

private:
    class Request;

    std::unique_ptr<Request> request_;
};

}
