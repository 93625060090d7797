#pragma once

#include "host/link/report_pipe.hpp"

#include <memory>
#include <string>

namespace kfast {

/// To a simulated board that listens at `path` (sim_socket.hpp). Throws Failure with no_device if none does.
std::unique_ptr<ReportPipe> open_socket_pipe(const std::string& path);

}
