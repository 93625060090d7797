#pragma once

#include <cstddef>
#include <functional>

namespace kfast {

/// Told again and again how many of so many steps of something long are done.
using ProgressCallback = std::function<void(std::size_t done, std::size_t total)>;

inline void ignore_progress(std::size_t /*done*/, std::size_t /*total*/) {}

}
