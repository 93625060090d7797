#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace kfast {

/// How far something has come that sends bytes: "[#####               ]  25 %  12.3 KB/s  3 s left". The rate
/// is shown after a while only. `total` is more than 0.
std::string progress_text(std::size_t done, std::size_t total, std::chrono::duration<double> elapsed);

/// Likewise of something that has steps: "[#####               ]  25 %  3 s left".
std::string work_text(std::size_t done, std::size_t total, std::chrono::duration<double> elapsed);

}
