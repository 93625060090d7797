#pragma once

#include "host/commands/flash/flash_contents.hpp"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// Adds --pin to `app`, whose parsing `pins` must outlive.
CLI::Option* declare_pin_option(CLI::App& app, std::vector<std::string>& pins);

/// The settings of a Pico as chosen on a command line.
struct SettingsOptions {
    std::string config;
    std::string panel;
    std::string beam = {};
    std::vector<std::string> pins; ///< "dc=8"
};

/// Adds --config, --panel, --beam and --pin to `app`. `options` must outlive its parsing.
void declare_settings_options(CLI::App& app, SettingsOptions& options);

/// The names that --panel takes: of the ready configurations for panels.
std::vector<std::string_view> ready_panels();
/// Throws CLI::ValidationError for a name that is not among them.
BoardSettings ready_settings(const std::string& panel);

/// Another GPIO for a role.
struct PinChange {
    PinRole role;
    Pin pin; ///< no_pin: none
};

/// The settings that a command line is about: those of a configuration, of the ready configuration of a
/// panel or a beam, or those that a board has, with other pins.
class SettingsChoice {
public:
    /// Throws Failure for a configuration that does not exist or is invalid, and as on() does; and
    /// CLI::ValidationError for what is no panel or no pin.
    explicit SettingsChoice(const SettingsOptions& options);

    /// Whether there is anything to be written.
    bool is_made() const { return base_.has_value() || !changes_.empty(); }
    /// Whether that depends on what a board has already.
    bool changes_board() const { return !base_.has_value() && !changes_.empty(); }

    /// The new settings of a board that has these, or none; nothing if they are the same. Throws Failure for
    /// pins that a Pico cannot use like that, naming the option, and if there is nothing to change.
    std::optional<NamedSettings> on(const std::optional<BoardSettings>& board) const;

private:
    NamedSettings changed(NamedSettings settings) const;

    std::optional<NamedSettings> base_;
    std::vector<PinChange> changes_;
};

}
