#include "host/commands/flash/settings_choice.hpp"

#include "firmware/settings/rp2040_pins.hpp"
#include "host/beam/profile_choice.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/config/config_input.hpp"
#include "host/config/configurations.hpp"
#include "host/config/mistake_text.hpp"
#include "host/config/panel_labels.hpp"
#include "host/config/setting_words.hpp"
#include "host/fit/display.hpp"
#include "host/fit/other_hardware.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace kfast {
namespace {

constexpr std::string_view prefix = "pico-";
constexpr std::string_view beam_prefix = "pico-xy-";

CLI::ValidationError wrong_pin(const std::string& text, const std::string& reason)
{
    return CLI::ValidationError{"--pin", "'" + visible(text) + "': " + reason};
}

std::string configuration_of(const std::string& panel)
{
    const std::vector<std::string_view> known = ready_panels();
    if (std::ranges::find(known, panel) != known.end())
        return std::string{prefix} + panel;
    if (const auto hint = fit::undriven_panel_text(panel))
        throw CLI::ValidationError("--panel", "'" + visible(panel) + "' is unknown: " + *hint);
    if (const fit::Display* display = fit::display_named(panel); display != nullptr && display->is_driven)
        throw CLI::ValidationError(
            "--panel", "'" + panel + "' has no ready configuration: make one for --config of another one, " +
                           "kfast config pico-st7789 -o FILE.kdl, with panel " + panel +
                           " in it (docs/config.md)");
    throw CLI::ValidationError("--panel", "'" + visible(panel) +
                                              "' has no ready configuration: " + suggestion(panel, known) +
                                              ", or name a file of settings with --config (docs/config.md)");
}

PinRole role_of(const std::string& text, std::string_view word)
{
    const auto name = std::ranges::find(pin_role_names, word);
    if (name != pin_role_names.end())
        return static_cast<PinRole>(name - pin_role_names.begin());
    if (const auto printed = config::role_printed_as(word))
        throw wrong_pin(text, "here it is called " + config::word_of(*printed));
    throw wrong_pin(text, "there is no such role: " + suggestion(word, pin_role_names));
}

Pin pin_of(const std::string& text, std::string_view word)
{
    if (word == "none")
        return no_pin;
    int pin = -1;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), pin);
    if (error != std::errc{} || rest != word.data() + word.size() || pin < 0 || pin >= rp2040::pin_count)
        throw wrong_pin(text, "the number of a GPIO is expected behind the =, like 18 for GP18, or none");
    return static_cast<Pin>(pin);
}

PinChange change_of(const std::string& text)
{
    const std::size_t equals = text.find('=');
    if (equals == text.npos)
        throw wrong_pin(text, "write ROLE=GPIO, like dc=8");
    const std::string_view words{text};
    return {role_of(text, words.substr(0, equals)), pin_of(text, words.substr(equals + 1))};
}

std::string text_of(const PinChange& change)
{
    return config::word_of(change.role) + '=' +
           (change.pin == no_pin ? "none" : std::to_string(int{change.pin}));
}

void apply(const PinChange& change, BoardSettings& settings)
{
    settings.pin(change.role) = change.pin;
    if (change.role == PinRole::tearing && !leads_beam(settings.bus))
        settings.panel.tearing_effect = change.pin != no_pin;
}

/// The option that a mistake comes from, if it is one of these.
const PinChange* culprit(const SettingsMistake& mistake, std::span<const PinChange> changes)
{
    const auto is_in = [&](const std::optional<PinUser>& user) {
        return std::ranges::find_if(changes, [&](const PinChange& change) { return user == change.role; });
    };
    auto found = is_in(mistake.user);
    if (found == changes.end())
        found = is_in(mistake.other);
    return found == changes.end() ? nullptr : &*found;
}

void require_rules(const NamedSettings& settings, std::span<const PinChange> changes)
{
    std::string text;
    for (const SettingsMistake& mistake : config::mistakes(settings.settings)) {
        const PinChange* const change = culprit(mistake, changes);
        const config::Finding finding = config::text_of(mistake, settings.settings);
        text += (text.empty() ? "" : "\nkfast: ") +
                (change == nullptr ? settings.name : "--pin " + text_of(*change)) + ": " + finding.message +
                ": " + finding.hint;
    }
    if (!text.empty())
        throw Failure{text, ExitStatus::wrong_usage};
}

/// The ready configuration of that beam, or another one with its profile, which may be that of a file.
NamedSettings settings_for_beam(const std::string& beam)
{
    const std::string ready = std::string{beam_prefix} + beam;
    if (std::ranges::find(config::configurations(), ready, &config::Configuration::name) !=
        config::configurations().end())
        return {config::chosen_settings(ready), ready};
    const std::string base = config::default_configuration(BusKind::dac);
    NamedSettings settings{config::chosen_settings(base), base + " with beam " + beam};
    settings.settings.beam = chosen_profile(beam);
    require_rules(settings, {});
    return settings;
}

}

std::vector<std::string_view> ready_panels()
{
    std::vector<std::string_view> known;
    for (const config::Configuration& configuration : config::configurations())
        if (!configuration.name.starts_with(beam_prefix))
            known.push_back(configuration.name.substr(prefix.size()));
    return known;
}

BoardSettings ready_settings(const std::string& panel)
{
    return config::chosen_settings(configuration_of(panel));
}

CLI::Option* declare_pin_option(CLI::App& app, std::vector<std::string>& pins)
{
    const OptionHeading heading{app, option_group::display};
    return app
        .add_option("--pin", pins,
                    "A pin that is elsewhere, like dc=8, or select=none; may be repeated (docs/config.md has "
                    "the roles)")
        ->type_name("ROLE=GPIO")
        ->allow_extra_args(false);
}

void declare_settings_options(CLI::App& app, SettingsOptions& options)
{
    const OptionHeading heading{app, option_group::display};
    CLI::Option* const config =
        app.add_option("--config", options.config,
                       "Settings: a ready configuration or a file, as for 'kfast config'")
            ->type_name("INPUT");
    offer_names(reads_file(config), config::configurations());
    CLI::Option* const panel =
        app.add_option("--panel", options.panel,
                       "The same, by the display: the ready configuration of gc9a01, st7789 …")
            ->type_name("NAME")
            ->excludes(config);
    offer(panel, ready_panels());
    CLI::Option* const beam =
        app.add_option("--beam", options.beam,
                       "For a vector display: scope, crt, galvo, or a file that describes one, FILE.kdl")
            ->type_name("PROFILE")
            ->excludes(config)
            ->excludes(panel);
    offer(reads_file(beam), profile_names());
    declare_pin_option(app, options.pins);
}

SettingsChoice::SettingsChoice(const SettingsOptions& options)
{
    for (const std::string& text : options.pins) {
        const PinChange change = change_of(text);
        if (std::ranges::find(changes_, change.role, &PinChange::role) != changes_.end())
            throw wrong_pin(text, "there is another pin for " + config::word_of(change.role));
        changes_.push_back(change);
    }
    const std::string name = options.panel.empty() ? options.config : configuration_of(options.panel);
    if (!options.beam.empty())
        base_ = changed(settings_for_beam(options.beam));
    else if (!name.empty())
        base_ = changed({config::chosen_settings(name), name});
}

std::optional<NamedSettings> SettingsChoice::on(const std::optional<BoardSettings>& board) const
{
    if (base_ || changes_.empty())
        return base_;
    if (!board)
        throw Failure{"--pin alone changes the settings that the board has, and none can be read there: name "
                      "the display with --panel, or settings with --config",
                      ExitStatus::wrong_usage};
    return changed({*board, "the board"});
}

NamedSettings SettingsChoice::changed(NamedSettings settings) const
{
    if (changes_.empty())
        return settings;
    for (const PinChange& change : changes_)
        apply(change, settings.settings);
    require_rules(settings, changes_);
    settings.name += " with";
    for (const PinChange& change : changes_)
        settings.name += ' ' + text_of(change);
    return settings;
}

}
