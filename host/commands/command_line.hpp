#pragma once

namespace kfast {

/// The whole program. Returns its exit status (ExitStatus).
int run_command_line(int count, const char* const* arguments);

}
