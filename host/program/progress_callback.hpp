#pragma once

#include <cstddef>
#include <functional>

namespace kfast {

/// Called repeatedly with how many of all steps of a long operation are done.
using ProgressCallback = std::function<void(std::size_t done, std::size_t total)>;

inline void ignore_progress(std::size_t /*done*/, std::size_t /*total*/) {}

}
