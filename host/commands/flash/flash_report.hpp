#pragma once

#include "host/commands/flash/flash_job.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace kfast {

/// What a job has done, or would do, to flash. Several lines.
std::string flash_text(const FlashOutcome& outcome, FlashPurpose purpose);
std::string player_text(const PlayerOutcome& player);
/// Of both; the player is null if it was not waited for.
nlohmann::ordered_json flash_json(const FlashOutcome& outcome, const std::optional<PlayerOutcome>& player);

}
