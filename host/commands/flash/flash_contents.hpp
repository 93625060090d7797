#pragma once

#include "firmware/settings/board_settings.hpp"
#include "host/compile/scene_file.hpp"
#include "host/flash/flash_image.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// Settings of a board, and their name in messages.
struct NamedSettings {
    BoardSettings settings;
    std::string name;
};

/// A firmware for the Pico, and the file that it comes from.
struct NamedFirmware {
    std::vector<std::byte> image;
    std::string name;
};

/// A firmware, settings and a scene, all or some of them, which go together.
struct FlashParts {
    const NamedFirmware* firmware = nullptr;
    const NamedSettings* settings = nullptr;
    const SceneFile* scene = nullptr;
    std::string scene_name = {};
};

/// What is to be written to the flash of a Pico, and its description.
struct FlashContents {
    std::vector<FlashRegion> regions;
    std::string words; ///< "firmware of 61532 bytes, settings of pico-st7789, scene of 303 bytes"
};

/// Prints warnings to standard error: of firmware that does not say for which bus it is; of clips and inputs
/// that the settings name and the scene does not have.
/// Throws Failure for settings whose display is on another bus than the firmware's, and with no_room for a
/// scene that is too large.
FlashContents flash_contents(const FlashParts& parts);

/// Settings for another bus than the firmware's would leave the display dark. Throws Failure, and warns of
/// firmware that does not say its bus.
void require_bus(const NamedFirmware& firmware, const NamedSettings& settings);

}
