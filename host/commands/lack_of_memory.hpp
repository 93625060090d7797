#pragma once

namespace kfast {

inline constexpr const char* lack_of_memory = "not enough memory: try a smaller --size, or a smaller file";

/// From now on the program ends with that message and the status of a wrong input, without files that are
/// half written, also where std::bad_alloc cannot get through: some functions of libraries promise to throw
/// nothing, and need memory.
void report_lack_of_memory_everywhere();

}
