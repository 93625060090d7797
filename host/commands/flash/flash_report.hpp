#pragma once

#include "host/commands/devices/sending.hpp"
#include "host/commands/flash/flash_environment.hpp"
#include "host/commands/flash/flash_job.hpp"
#include "host/flash/flashing.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace kfast {

/// The progress of flashing, on standard error: a bar for each phase on a terminal, else a line when it
/// begins.
class FlashProgress {
public:
    explicit FlashProgress(ProgressBar::Shown shown) : shown_{shown} {}

    void report(FlashPhase phase, std::size_t done, std::size_t total);

private:
    void begin(FlashPhase phase, std::size_t total);

    ProgressBar::Shown shown_;
    std::optional<FlashPhase> phase_;
    std::optional<ProgressBar> bar_;
};

enum class ListForm { text, json };

/// Prints all boards that could be flashed: those in their boot loaders, those that run KFAST, and drives.
/// Throws Failure with no_device if there are none.
void print_flash_list(FlashEnvironment& environment, ListForm form);

/// What a job has done, or would do, to flash. Several lines.
std::string flash_text(const FlashOutcome& outcome, FlashPurpose purpose);
std::string player_text(const PlayerOutcome& player);
/// The results for both; the player is null if it was not waited for.
nlohmann::ordered_json flash_json(const FlashOutcome& outcome, const std::optional<PlayerOutcome>& player);

}
