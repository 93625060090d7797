#pragma once

namespace kfast {

/// The whole program. Returns its exit status (exit_status.hpp).
int run_command_line(int count, const char* const* arguments);

}
