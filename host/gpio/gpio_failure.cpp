#include "host/gpio/gpio_failure.hpp"

#include <cerrno>
#include <system_error>

namespace kfast {
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

/// The lines that somebody has, as far as the kernel tells.
std::string taken_lines(const FoundLines& found)
{
    std::string text;
    for (const unsigned offset : found.offsets) {
        const std::string user = found.chip.user_of(offset);
        if (!user.empty())
            text += (text.empty() ? "line " : ", line ") + std::to_string(offset) + " by '" + user + '\'';
    }
    return text.empty() ? "one of the lines" : text;
}

}

std::string text_of(const GpioChip& chip) { return chip.name() + " (" + chip.label() + ')'; }

Failure cannot_open_chip(const std::string& path, int error)
{
    switch (error) {
    case EACCES:
    case EPERM:
        return Failure{"you may not open " + path +
                           ": where there is a group 'gpio', join it and log in again (sudo usermod -aG gpio "
                           "$USER); elsewhere a rule of udev allows it:\n  SUBSYSTEM==\"gpio\", "
                           "KERNEL==\"gpiochip*\", TAG+=\"uaccess\", GROUP=\"plugdev\", MODE=\"0660\"",
                       ExitStatus::no_permission};
    case ENOENT:
    case ENODEV:
    case ENXIO:
    case ENOTTY:
        return Failure{path + " is no GPIO chip: 'gpiodetect' lists those that there are",
                       ExitStatus::no_device};
    default:
        return Failure{path + " cannot be opened: " + reason(error), ExitStatus::refused};
    }
}

Failure cannot_have_lines(const FoundLines& found, int error, GpioDrive drive)
{
    const std::string chip = text_of(found.chip);
    if (error == EBUSY)
        return Failure{chip + ": taken: " + taken_lines(found) +
                           ": end that program, or turn the driver off; 'gpioinfo " + found.chip.name() +
                           "' tells who has what",
                       ExitStatus::refused};
    if (error == EACCES || error == EPERM)
        return cannot_open_chip("/dev/" + found.chip.name(), error);
    if (error == ENODEV)
        return Failure{chip + " is gone: was it unplugged, or its driver unbound?", ExitStatus::unplugged};
    const bool is_open = drive == GpioDrive::open_drain;
    return Failure{chip + " does not give these lines as " + (is_open ? "open-drain " : "") +
                       "outputs: " + reason(error) + ": take others",
                   ExitStatus::refused};
}

Failure cannot_set_lines(const std::string& chip, int error)
{
    return Failure{chip + " does not set its lines any more: " + reason(error) +
                       ": was it unplugged, or its driver unbound?",
                   ExitStatus::unplugged};
}

}
