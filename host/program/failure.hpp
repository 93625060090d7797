#pragma once

#include "host/program/exit_status.hpp"

#include <stdexcept>
#include <string>

namespace kfast {

/// Something cannot be done, mostly because the input is wrong, or a file cannot be read or written: kfast
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

}
