#pragma once

#include "firmware/link/message.hpp"
#include "host/commands/flash/flash_environment.hpp"
#include "host/commands/flash/flash_plan.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace kfast {

enum class FlashPurpose { write, dry_run, verify_only };

/// What the user asks for, besides the contents of flash.
struct FlashOrder {
    FlashPurpose purpose = FlashPurpose::write;
    PlaceWish place;
    std::optional<BootLines> lines = std::nullopt; ///< by which the board enters its boot loader first
    Milliseconds last_patience{10'000};            ///< for a boot loader, and for a player
};

/// The result for the flash.
struct FlashOutcome {
    std::string contents;                 ///< in words
    std::vector<std::uint32_t> addresses; ///< of the sectors of these
    std::string serial = {};              ///< of the player that was left for this; empty: none was
    std::string port = {};                ///< of the boot loader; empty: none was used
    std::string drive = {};               ///< the folder; empty: none was used
    /// Addresses of sectors that held something else; nothing if that is not known.
    std::optional<std::vector<std::uint32_t>> differing = std::nullopt;
    std::size_t written = 0; ///< sectors
    bool verified = false;
    bool restarted = false;
};

/// The result for the player.
struct PlayerOutcome {
    std::string name;
    link::Playing playing;
    std::optional<std::uint8_t> left_slot; ///< that would have played; the built-in scene was chosen instead
};

/// Writes the contents of a plan to a board, from finding it to checking that it plays.
class FlashJob {
public:
    /// The arguments must outlive it.
    FlashJob(FlashEnvironment& environment, const FlashPlan& plan, const FlashOrder& order,
             const FlashProgressCallback& on_progress);

    /// Finds the board and does with its flash what the order says; a board that was written to restarts. A
    /// dry run affects no board but one that is in its boot loader, whose flash is read.
    ///
    /// A board that was asked to leave its player for this, and to which nothing was written, restarts as it
    /// was, also when this throws, unless its boot loader cannot be opened or has not come yet. Throws
    /// Failure, see docs/flash.md.
    FlashOutcome run();

    /// After run() has restarted a board: waits until its player answers, and lets it play the scene that was
    /// flashed. Throws Failure.
    PlayerOutcome await_player();

private:
    FlashOutcome run_on(const BootBoard& board);
    FlashOutcome run_on(const DeviceAddress& device);
    FlashOutcome run_on(const Uf2Drive& drive);
    FlashOutcome run_with(BootLoader& boot_loader);
    FlashOutcome untouched();

    BootBoard entered_by_lines();
    void ask_to_leave(const DeviceAddress& address);
    RemoteDevice player_at(const DeviceAddress& address);
    BootBoard await_boot_loader(const std::vector<BootBoard>& before);
    std::unique_ptr<BootLoader> opened(const BootBoard& board);
    std::optional<Uf2Drive> drive_instead(const Failure& failure);
    void write(BootLoader& boot_loader, const FlashImage& image, const std::vector<std::size_t>& differing,
               FlashOutcome& outcome);
    void leave(BootLoader& boot_loader, FlashOutcome& outcome);
    void restart(BootLoader& boot_loader);
    void let_play_again(BootLoader& boot_loader);
    void remember_devices();
    bool is_new(const DeviceAddress& device) const;
    PlayerOutcome player_of(const DeviceAddress& address);
    link::Playing playing_on(RemoteDevice& device);

    FlashEnvironment& environment_;
    const FlashPlan& plan_;
    const FlashOrder& order_;
    const FlashProgressCallback& on_progress_;
    std::string port_;              ///< of the boot loader
    std::string asked_;             ///< the serial number of the device that has left its player for this
    bool has_just_come_ = false;    ///< the boot loader, for which udev may still have to do something
    bool is_written_ = false;       ///< or half of it is
    std::set<std::string> devices_; ///< that were there already before the board restarted
};

}
