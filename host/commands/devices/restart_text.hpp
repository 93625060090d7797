#pragma once

#include "firmware/link/restarts.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace kfast {

/// "by its watchdog once, while it played slot 2". There is at least one.
std::string restart_text(const link::Restarts& restarts);
/// What a device in safe mode plays, and what somebody can do about it.
std::string safe_mode_text(const link::Restarts& restarts);
/// Null if there was none.
nlohmann::ordered_json restart_json(const link::Restarts& restarts);

}
