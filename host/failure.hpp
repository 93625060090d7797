#pragma once

#include <stdexcept>

namespace kfast {

/// The input is wrong, or a file cannot be read or written: kfast prints the text and ends with status 1.
/// The text names the file, says what is wrong and what would help.
class Failure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}
