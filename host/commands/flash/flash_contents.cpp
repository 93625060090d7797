#include "host/commands/flash/flash_contents.hpp"

#include "core/scene/scene_view.hpp"
#include "firmware/settings/board_settings.hpp"
#include "host/commands/inputs/input_options.hpp"
#include "host/commands/text/summary.hpp"
#include "host/config/config_input.hpp"
#include "host/config/firmware_images.hpp"
#include "host/config/pico_flash.hpp"
#include "host/config/setting_words.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <iostream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

namespace {

using Names = std::set<std::string_view>;

/// The names of the controls whose actions `are_meant`.
Names names_of_controls(const BoardSettings& settings, bool (*are_meant)(ControlAction))
{
    Names names;
    for (const Control& control : settings.controls)
        if (control.kind != ControlKind::none && are_meant(control.action) && !control.name.view().empty())
            names.insert(control.name.view());
    return names;
}

Names named_clips(const BoardSettings& settings)
{
    Names names = names_of_controls(settings, has_clip);
    if (!settings.clip.view().empty())
        names.insert(settings.clip.view());
    return names;
}

/// `known` are the names of the scene.
std::string hint(std::string_view name, std::string_view what, const std::vector<std::string_view>& known)
{
    return known.empty() ? "the scene has no " + std::string{what} + 's' : visible(suggestion(name, known));
}

std::string missing_clip(std::string_view name, const SceneView& scene)
{
    return "there is no clip " + in_quotes(name) +
           ", the whole scene will play in its place: " + hint(name, "clip", clip_names(scene));
}

bool has_number(const SceneView& scene, std::string_view input)
{
    const auto number = scene.input(input);
    return number && (scene.number_inputs() >> *number & 1U) != 0;
}

std::string missing_input(std::string_view name, const SceneView& scene)
{
    return "there is no " + std::string{scene.input(name) ? "number among the inputs called " : "input "} +
           in_quotes(name) + ", its button or knob will do nothing: " +
           hint(name, "input", input_names(scene, InputType::number));
}

/// The clips and inputs that settings name and a scene does not have, each once by name, in words: in place
/// of such a clip a board plays the whole scene, and a control for such an input does nothing.
std::vector<std::string> missing_names(const BoardSettings& settings, const SceneView& scene)
{
    std::vector<std::string> found;
    for (const std::string_view name : named_clips(settings))
        if (!scene.clip(name))
            found.push_back(missing_clip(name, scene));
    for (const std::string_view name : names_of_controls(settings, has_input))
        if (!has_number(scene, name))
            found.push_back(missing_input(name, scene));
    return found;
}

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
