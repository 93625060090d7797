#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace kfast {

/// The exit status of kfast. The numbers never change: scripts rely on them.
enum class ExitStatus : int {
    done = 0,
    wrong_input = 1,
    wrong_usage = 2,
    no_device = 3,
    no_permission = 4,
    unplugged = 5,
    wrong_version = 6,
    no_room = 7,
    refused = 8,
    timed_out = 9,
    not_verified = 10,
    wrong_chip = 11,
    interrupted = 130, ///< as shells count SIGINT
};

struct ExitMeaning {
    ExitStatus status;
    const char* meaning;
};

/// The meaning of each status, as the help and docs/devices.md have it.
inline constexpr std::array exit_meanings{
    ExitMeaning{ExitStatus::done, "done"},
    ExitMeaning{ExitStatus::wrong_input, "the input is wrong, or a file cannot be read or written"},
    ExitMeaning{ExitStatus::wrong_usage, "the usage is wrong"},
    ExitMeaning{ExitStatus::no_device, "no device, or not the one that is asked for"},
    ExitMeaning{ExitStatus::no_permission, "a device may not be opened"},
    ExitMeaning{ExitStatus::unplugged, "a device was unplugged meanwhile"},
    ExitMeaning{ExitStatus::wrong_version, "the firmware of a device does not go with this kfast"},
    ExitMeaning{ExitStatus::no_room, "a device has no room for the scene or the firmware"},
    ExitMeaning{ExitStatus::refused, "a device refused something else"},
    ExitMeaning{ExitStatus::timed_out, "a device did not answer"},
    ExitMeaning{ExitStatus::not_verified, "what was written reads back differently"},
    ExitMeaning{ExitStatus::wrong_chip, "a board has another chip than the firmware is for"},
    ExitMeaning{ExitStatus::interrupted, "interrupted by Ctrl-C"},
};

/// Something cannot be done, mostly because the input is invalid, or a file cannot be read or written: kfast
/// prints the text and ends with the status. The text names the file or the device, says what is wrong and
/// what would help.
class Failure : public std::runtime_error {
public:
    explicit Failure(const std::string& text, ExitStatus status = ExitStatus::wrong_input)
        : std::runtime_error{text}, status_{status}
    {
    }

    ExitStatus status() const { return status_; }

private:
    ExitStatus status_;
};

/// The hint where Error::too_slow is reported.
inline constexpr std::string_view slow_scene_hint =
    "show less at once, use symbols less often, or draw with fewer points";

}
