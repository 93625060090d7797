#include "host/commands/flash/flash_plan.hpp"

#include "firmware/settings/controller_facts.hpp"
#include "host/commands/options/fit_options.hpp"
#include "host/config/config_input.hpp"
#include "host/config/configurations.hpp"
#include "host/config/firmware_images.hpp"
#include "host/config/setting_words.hpp"
#include "host/fit/beam_fit.hpp"
#include "host/fit/board_choice.hpp"
#include "host/fit/fit_report.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <iostream>

namespace kfast {
namespace {

/// In the order of BusKind.
constexpr std::array buses{BusKind::spi, BusKind::i2c, BusKind::parallel_8, BusKind::dac};

NamedSettings default_settings(BusKind bus)
{
    const std::string name = config::default_configuration(bus);
    return {config::chosen_settings(name), name};
}

NamedFirmware loaded(const std::filesystem::path& file)
{
    return {config::load_firmware(file), file.string()};
}

/// The buses that the settings may have.
std::vector<BusKind> buses_of(const SettingsChoice& settings)
{
    if (settings.is_made() && !settings.changes_board())
        return {settings.on(std::nullopt)->settings.bus};
    return {buses.begin(), buses.end()};
}

std::vector<NamedFirmware> firmwares_of(const PlanWish& wish, const SettingsChoice& settings,
                                        std::span<const std::filesystem::path> images)
{
    if (wish.no_firmware)
        return {};
    if (!wish.firmware.empty())
        return {loaded(wish.firmware)};
    std::vector<NamedFirmware> all;
    for (const BusKind bus : buses_of(settings))
        all.push_back(loaded(config::image_for(bus, images)));
    return all;
}

fit::FitReport report_on(const SceneFile& scene, const fit::Target& target)
{
    return fit::fit_report({.scene = scene.view, .item_names = scene.item_names, .target = target});
}

void require_room(const std::string& name, const fit::Target& target,
                  const std::vector<std::string>& shortages)
{
    if (!shortages.empty())
        throw Failure{misfit_text(name, target, shortages) +
                          "\n  Shorten the scene, or draw it with fewer points; 'kfast fit' tells more",
                      ExitStatus::no_room};
}

void warn_of_slowness(const std::string& name, const fit::FitReport& report)
{
    if (!report.hang.empty())
        std::cerr << name << ": warning: " << report.hang << '\n';
    if (!report.slowness.empty())
        std::cerr << name << ": warning: it plays slower than it wants on this board: " << report.slowness
                  << '\n';
}

void check_panel(const std::string& name, const SceneFile& scene, const fit::Target& target)
{
    const fit::FitReport report = report_on(scene, target);
    require_room(name, target, report.shortages);
    warn_of_slowness(name, report);
}

void check_beam(const std::string& name, const SceneFile& scene, const fit::Target& target)
{
    const fit::BeamFit report = fit::beam_fit(scene.view, target, 0);
    require_room(name, target, report.shortages);
    for (const std::string& weakness : report.weaknesses)
        std::cerr << name << ": warning: " << weakness << '\n';
}

/// A board that has no firmware, or one for another bus, would stay dark.
void require_firmware_on(const FoundOnBoard& found, const NamedSettings& settings)
{
    if (!config::begins_with_boot_block(found.firmware))
        throw Failure{"there is no firmware on the board: leave out --no-firmware"};
    const auto bus = config::marked_bus(found.firmware);
    if (bus && *bus != settings.settings.bus)
        throw Failure{"the firmware on the board is for displays on " + config::word_of(*bus) +
                      ", but the display of " + settings.name + " is on " +
                      config::word_of(settings.settings.bus) + ": leave out --no-firmware"};
}

}

FlashPlan::FlashPlan(const PlanWish& wish, std::span<const std::filesystem::path> images)
    : scene_name_{wish.scene}, settings_{wish.settings}
{
    if (wish.no_firmware && wish.scene.empty() && !settings_.is_made())
        throw CLI::RequiredError(
            "with --no-firmware, a scene or settings (--config, --panel, --beam, --pin)");
    if (!wish.scene.empty())
        scene_.emplace(load_scene(wish.scene));
    firmwares_ = firmwares_of(wish, settings_, images);
    if (settings_.is_made() && !settings_.changes_board())
        fixed_contents_ = checked_contents(std::nullopt);
    else
        static_cast<void>(flash_contents({.scene = scene_ ? &*scene_ : nullptr, .scene_name = scene_name_}));
}

const NamedFirmware* FlashPlan::firmware_for(BusKind bus) const
{
    if (firmwares_.empty())
        return nullptr;
    return depends_on_bus() ? &firmwares_[static_cast<std::size_t>(bus)] : &firmwares_.front();
}

NamedSettings FlashPlan::effective(const std::optional<NamedSettings>& given,
                                   const std::optional<FoundOnBoard>& found) const
{
    if (given)
        return *given;
    if (found && found->settings)
        return {*found->settings, "the board"};
    const auto bus = firmwares_.size() == 1 ? config::marked_bus(firmwares_.front().image) : std::nullopt;
    return default_settings(bus.value_or(BusKind::spi));
}

void FlashPlan::check_fit(const BoardSettings& settings) const
{
    const fit::Target target = fit::pico_target(settings);
    if (target.beam)
        check_beam(scene_name_, *scene_, target);
    else
        check_panel(scene_name_, *scene_, target);
}

FlashContents FlashPlan::checked_contents(const std::optional<FoundOnBoard>& found) const
{
    const auto given = settings_.on(found ? found->settings : std::nullopt);
    const NamedSettings settings = effective(given, found);
    const NamedFirmware* const firmware = firmware_for(settings.settings.bus);
    if (scene_)
        check_fit(settings.settings);
    if (firmware != nullptr && !given && found && found->settings)
        require_bus(*firmware, settings);
    return flash_contents({.firmware = firmware,
                           .settings = given ? &*given : nullptr,
                           .scene = scene_ ? &*scene_ : nullptr,
                           .scene_name = scene_name_});
}

FlashContents FlashPlan::contents_for(const std::optional<FoundOnBoard>& found) const
{
    FlashContents contents = fixed_contents_ ? *fixed_contents_ : checked_contents(found);
    if (firmwares_.empty() && found)
        require_firmware_on(*found, effective(settings_.on(found->settings), found));
    if (!(found && found->settings) && depends_on_board())
        std::cerr << "kfast: warning: "
                  << (found ? "the board does not know its display"
                            : "which display the board has is not known")
                  << ", so the firmware is that for " << config::default_configuration(BusKind::spi)
                  << ": name yours with --panel, --beam or --config\n";
    return contents;
}

void FlashPlan::require_room_with(std::string_view panel, Size size) const
{
    const auto controller = std::ranges::find(controller_names, panel);
    if (fixed_contents_ || !scene_ || controller == controller_names.end() || size.width <= 0 ||
        size.height <= 0)
        return;
    BoardSettings settings = default_settings(BusKind::spi).settings;
    settings.panel = facts_of(static_cast<Controller>(controller - controller_names.begin())).default_value;
    settings.panel.glass = size;
    const fit::Target target = fit::pico_target(settings);
    require_room(scene_name_, target, report_on(*scene_, target).shortages);
}

}
