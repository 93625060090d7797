#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string_view>

namespace kfast {

/// Under which the help lists commands.
inline constexpr const char* making_group = "Make a scene";
inline constexpr const char* seeing_group = "See it";
inline constexpr const char* board_group = "Put it on a board";
inline constexpr const char* elsewhere_group = "Put it elsewhere";
inline constexpr const char* devices_group = "Devices that are attached (docs/devices.md)";
inline constexpr const char* help_group = "Help, editors and shells (docs/editors.md)";

/// One subcommand of kfast.
struct Command {
    const char* name;
    const char* summary;
    const char* example; ///< for the end of its help
    /// Declares the arguments and, as CLI11's callback, what is done with them. The callback throws Failure
    /// for a wrong input or file, or what a device says, and CLI::ParseError for a wrong use.
    void (*declare)(CLI::App& app);
    std::span<const std::string_view> subcommands = {}; ///< if there are any, one of them follows
    const char* group = making_group;
};

extern const Command new_command;
extern const Command import_command;
extern const Command compile_command;
extern const Command check_command;
extern const Command info_command;
extern const Command render_command;
extern const Command preview_command;
extern const Command hash_command;
extern const Command simulate_command;
extern const Command panel_command;
extern const Command boards_command;
extern const Command panels_command;
extern const Command export_command;
extern const Command fit_command;
extern const Command config_command;
extern const Command wiring_command;
extern const Command uf2_command;
extern const Command flash_command;
extern const Command devices_command;
extern const Command play_command;
extern const Command live_command;
extern const Command pause_command;
extern const Command resume_command;
extern const Command arm_command;
extern const Command disarm_command;
extern const Command seek_command;
extern const Command speed_command;
extern const Command brightness_command;
extern const Command upload_command;
extern const Command slots_command;
extern const Command choose_command;
extern const Command erase_command;
extern const Command boot_command;
extern const Command install_udev_command;
extern const Command schema_command;
extern const Command completions_command;
extern const Command man_command;
extern const Command help_command;

/// Adds all of them to `kfast`.
void declare_commands(CLI::App& kfast);

}
