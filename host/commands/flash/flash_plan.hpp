#pragma once

#include "host/commands/flash/flash_contents.hpp"
#include "host/commands/flash/settings_choice.hpp"
#include "host/compile/scene_file.hpp"
#include "host/fit/target.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// What the user wants in flash.
struct PlanWish {
    std::string scene;    ///< a file; empty: none
    std::string firmware; ///< a file; empty: the image for the bus of the settings
    bool no_firmware = false;
    SettingsOptions settings;
};

/// What is on a board already, as far as it decides what is written.
struct FoundOnBoard {
    std::optional<BoardSettings> settings; ///< nothing if there are none, or if a Pico cannot follow them
    std::vector<std::byte> firmware;       ///< its first sector
};

/// What is to be in flash, read and checked before any board is touched. Which firmware it is, and whether
/// the scene fits, may depend on the settings that a board has.
class FlashPlan {
public:
    /// `images` are the folders of config::image_folders(). Prints warnings. Throws Failure for what cannot
    /// be read or used, and for a scene that does not fit the chosen settings; CLI::ParseError for a wrong
    /// use.
    FlashPlan(const PlanWish& wish, std::span<const std::filesystem::path> images);

    bool has_scene() const { return scene_.has_value(); }
    /// Whether the settings that a board has decide what it gets.
    bool depends_on_board() const { return changes_settings() || (!settings_.is_made() && depends_on_bus()); }
    /// Whether the board gets its own settings, changed: there is no other copy while they are written.
    bool changes_settings() const { return settings_.changes_board(); }

    /// What a board gets on which that was found; nothing is known of one whose flash cannot be read. Prints
    /// warnings. Throws Failure for parts that do not go together, and with no_room.
    FlashContents contents_for(const std::optional<FoundOnBoard>& found) const;

    /// Checks, as far as possible, that the scene finds room in a board that keeps its own settings and
    /// reports only this about its display. Throws Failure with no_room.
    void require_room_with(std::string_view panel, Size size) const;

private:
    bool depends_on_bus() const { return firmwares_.size() > 1; }
    const NamedFirmware* firmware_for(BusKind bus) const;
    NamedSettings effective(const std::optional<NamedSettings>& given,
                            const std::optional<FoundOnBoard>& found) const;
    void check_fit(const BoardSettings& settings) const;
    /// Checked to go together, and the scene to find room.
    FlashContents checked_contents(const std::optional<FoundOnBoard>& found) const;

    std::string scene_name_;
    std::optional<SceneFile> scene_;
    std::vector<NamedFirmware> firmwares_; ///< none, one, or those for all buses in the order of BusKind
    SettingsChoice settings_;
    std::optional<FlashContents> fixed_contents_; ///< if it does not depend on the board
};

}
