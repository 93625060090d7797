#include "host/commands/flash/flash_contents.hpp"

#include "host/commands/flash/missing_names.hpp"
#include "host/config/config_input.hpp"
#include "host/config/firmware_file.hpp"
#include "host/config/firmware_images.hpp"
#include "host/config/pico_flash.hpp"
#include "host/config/setting_words.hpp"
#include "host/program/failure.hpp"

#include <iostream>

namespace kfast {
namespace {

std::string size_words(std::size_t bytes) { return " of " + std::to_string(bytes) + " bytes"; }

void require_room(const std::string& name, std::size_t size)
{
    constexpr std::size_t room = pico_flash::scene_end - pico_flash::scene;
    if (size > room)
        throw Failure(name + ": " + std::to_string(size) + " bytes once compiled, " +
                          std::to_string(size - room) +
                          " more than a Pico has room for as its built-in scene: shorten the scene or draw "
                          "it with fewer "
                          "points",
                      ExitStatus::no_room);
}

void warn_of_names(const FlashParts& parts)
{
    for (const std::string& warning : missing_names(parts.settings->settings, parts.scene->view))
        std::cerr << parts.settings->name << ": warning: " << parts.scene_name << ": " << warning << '\n';
}

void add(FlashContents& contents, std::uint32_t address, std::vector<std::byte> bytes,
         const std::string& words)
{
    contents.words += (contents.words.empty() ? "" : ", ") + words;
    contents.regions.push_back({address, std::move(bytes)});
}

}

void require_bus(const NamedFirmware& firmware, const NamedSettings& settings)
{
    const BusKind wanted = settings.settings.bus;
    const std::optional<BusKind> bus = config::marked_bus(firmware.image);
    if (!bus)
        std::cerr << firmware.name << ": warning: it does not tell for which bus it is; settings of "
                  << settings.name << " want one for " << config::word_of(wanted) << ": "
                  << config::image_of(wanted) << '\n';
    else if (*bus != wanted)
        throw Failure(firmware.name + ": firmware for displays on " + config::word_of(*bus) +
                      ", but the display of " + settings.name + " is on " + config::word_of(wanted) +
                      ": take " + config::image_of(wanted));
}

FlashContents flash_contents(const FlashParts& parts)
{
    if (parts.firmware != nullptr && parts.settings != nullptr)
        require_bus(*parts.firmware, *parts.settings);
    if (parts.settings != nullptr && parts.scene != nullptr)
        warn_of_names(parts);
    FlashContents contents;
    if (parts.firmware != nullptr)
        add(contents, pico_flash::begin, parts.firmware->image,
            "firmware" + size_words(parts.firmware->image.size()));
    if (parts.settings != nullptr)
        add(contents, pico_flash::settings, config::settings_sector(parts.settings->settings),
            "settings of " + parts.settings->name);
    if (parts.scene != nullptr) {
        require_room(parts.scene_name, parts.scene->bytes.size());
        add(contents, pico_flash::scene, parts.scene->bytes, "scene" + size_words(parts.scene->bytes.size()));
    }
    return contents;
}

}
