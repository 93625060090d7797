#include "host/commands/command.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/config/config_input.hpp"
#include "host/config/config_text.hpp"
#include "host/config/configurations.hpp"
#include "host/config/firmware_images.hpp"
#include "host/config/pico_flash.hpp"
#include "host/config/setting_words.hpp"
#include "host/file/atomic_file.hpp"
#include "host/flash/uf2.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <span>

namespace kfast {
namespace {

namespace fs = std::filesystem;

struct ConfigOptions {
    std::string input;
    std::string output;
    bool list = false;
    bool quiet = false;
};

using SettingsBytes = std::vector<std::byte>;

SettingsBytes as_text(const BoardSettings& settings)
{
    const std::string text = config::config_text(settings);
    const auto bytes = std::as_bytes(std::span{text});
    return {bytes.begin(), bytes.end()};
}

SettingsBytes as_uf2(const BoardSettings& settings)
{
    const std::array regions{FlashRegion{pico_flash::settings, config::settings_sector(settings)}};
    return uf2_of(regions);
}

/// The ending of a file's name determines what is written into it.
struct OutputForm {
    const char* suffix;
    const char* noun;
    SettingsBytes (*bytes)(const BoardSettings& settings);
};

constexpr std::array output_forms{
    OutputForm{".kdl", "a text to edit", as_text},
    OutputForm{".bin", "the sector for 0x1003F000", config::settings_sector},
    OutputForm{".uf2", "for the drive RPI-RP2", as_uf2},
};

const OutputForm& form_of(const fs::path& output)
{
    for (const OutputForm& form : output_forms)
        if (output.extension() == form.suffix)
            return form;
    throw CLI::ValidationError(
        "--output", "'" + output.string() + "': settings are written as .kdl (text), .bin (sector) or .uf2");
}

void write_settings(const ConfigOptions& options, const BoardSettings& settings)
{
    const OutputForm& form = form_of(options.output);
    const fs::path output = output_path(options.output, options.input, "file that is read");
    write_file(output, form.bytes(settings));
    report_stream(options.quiet) << output.string() << ": settings of " << options.input << ", " << form.noun
                                 << '\n';
}

std::string first_comment(std::string_view text) { return std::string{text.substr(3, text.find('\n') - 3)}; }

void list_configurations()
{
    std::size_t width = 0;
    for (const config::Configuration& configuration : config::configurations())
        width = std::max(width, configuration.name.size());
    const std::string indent(width + 2, ' ');
    for (const config::Configuration& configuration : config::configurations()) {
        const std::string name{configuration.name};
        std::cout << name << indent.substr(name.size()) << first_comment(configuration.text) << '\n'
                  << indent << "firmware: " << config::image_of(config::chosen_settings(name).bus) << '\n';
    }
}

void run(const ConfigOptions& options)
{
    if (options.list)
        return list_configurations();
    if (options.input.empty())
        throw CLI::RequiredError("INPUT (kfast config --list tells what there is ready)");
    const bool is_printed = options.output.empty() || options.output == "-";
    if (!is_printed)
        static_cast<void>(form_of(options.output)); // before anything is reported about the input
    const BoardSettings settings = config::chosen_settings(options.input);
    if (is_printed)
        std::cout << config::config_text(settings);
    else
        write_settings(options, settings);
}

void declare_config(CLI::App& app)
{
    const auto options = std::make_shared<ConfigOptions>();
    CLI::Option* const input =
        app.add_option("INPUT", options->input,
                       "A ready configuration, or a .kdl, .bin or .uf2 file that holds one (docs/config.md)");
    CLI::Option* const output = declare_output(
        app, options->output, "A .kdl, .bin or .uf2 file (default, and -: the text is printed)",
        StandardOutput::is_meant);
    offer_names(reads_file(input, {".kdl", ".bin", ".uf2"}), config::configurations());
    app.add_flag("--list", options->list, "Name the ready configurations")->excludes(input)->excludes(output);
    declare_quiet(app, options->quiet);
    app.callback([options] { run(*options); });
}

}

const Command config_command{"config",
                             "Make, check and read the settings of a board: display, pins, controls",
                             "kfast config pico-st7789 -o gadget.kdl",
                             declare_config,
                             {},
                             board_group};

}
