#include "host/commands/command.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/render/picture_options.hpp"
#include "host/compile/scene_file.hpp"
#include "host/config/config_input.hpp"
#include "host/link/device_address.hpp"
#include "host/picture/png.hpp"
#include "host/preview/board_watcher.hpp"
#include "host/preview/window/window_layout.hpp"
#include "host/program/interruption.hpp"
#include "host/simulator/plugged_board.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

namespace kfast {
namespace {

namespace fs = std::filesystem;

struct SimulateOptions {
    std::string scene;
    const PanelChoice* panel = &panel_choices().front();
    std::string config; ///< instead of the panel
    std::string socket = sim_socket_path();
    std::string flash;
    std::string serial = "SIM";
    std::string picture;
    bool headless = false;
    bool frames = false;
};

/// Where programs keep their state, by the XDG base directory specification.
fs::path state_folder()
{
    if (const char* const state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state == '/')
        return state;
    if (const char* const home = std::getenv("HOME"); home != nullptr && *home != '\0')
        return fs::path{home} / ".local/state";
    throw Failure(
        "there is no home folder for the flash of the simulated board: name a file with --flash-file");
}

fs::path default_flash()
{
    const fs::path folder = state_folder() / "kfast";
    std::error_code why;
    fs::create_directories(folder, why);
    if (why)
        throw Failure(folder.string() + ": " + why.message() + ": name a file with --flash-file");
    return folder / "sim-flash.bin";
}

/// A validator of CLI11: empty if it is valid, else what is wrong.
std::string is_serial(const std::string& text)
{
    constexpr std::size_t max = 24;
    const bool is_plain =
        std::ranges::all_of(text, [](char letter) { return letter > ' ' && letter <= '~'; });
    if (is_plain && !text.empty() && text.size() <= max)
        return "";
    return "'" + visible(text) + "' is no serial number: 1 to 24 letters and digits, without spaces";
}

std::unique_ptr<PictureWindow> open_window(const SimulateOptions& options, Size picture)
{
    if (options.headless)
        return nullptr;
    auto window = PictureWindow::open("kfast simulate: " + options.serial,
                                      window_around({2 * picture.width, 2 * picture.height}));
    if (!window)
        std::cerr << "kfast: " << PictureWindow::no_window()
                  << ", so the board is not to be seen: "
                     "--print-frames prints what it shows\n";
    return window;
}

BoardSettings settings_of(const SimulateOptions& options)
{
    BoardSettings settings;
    settings.panel = options.panel->settings;
    if (!options.config.empty())
        settings = config::chosen_settings(options.config);
    if (leads_beam(settings.bus))
        throw Failure(options.config +
                      ": these settings lead a beam, and the simulated board has a panel: see "
                      "the scene with kfast preview --beam");
    settings.controls = {}; // they cannot be operated
    return settings;
}

void write_last(const Frame& shown, const std::string& file)
{
    write_png(file, widen(shown));
    std::cout << written_picture_text(file, "1 frame", shown.size, written_bytes(file)) << '\n';
}

void simulate(const SimulateOptions& options)
{
    const BoardSettings settings = settings_of(options);
    const auto scene = options.scene.empty() ? std::nullopt : std::optional{load_scene(options.scene)};
    ReportSocket plug{options.socket};
    FlashFile flash{options.flash.empty() ? default_flash() : fs::path{options.flash}, rp2040::flash_bytes};

    const RememberedInterruption remembered;
    BoardWatcher watcher{open_window(options, settings.panel.size()), options.frames ? &std::cout : nullptr,
                         was_interrupted};
    std::cout << "listening at " << options.socket << std::endl;
    run_plugged_board({settings,
                       {options.serial},
                       scene ? std::span<const std::byte>{scene->bytes} : std::span<const std::byte>{},
                       flash,
                       plug,
                       watcher});
    if (!options.picture.empty() && !watcher.last().pixels.empty())
        write_last(watcher.last(), options.picture);
}

void declare_simulated_panel(CLI::App& app, SimulateOptions& options)
{
    const OptionHeading heading{app, option_group::display};
    CLI::Option* panel = declare_panel_option(app, options.panel);
    reads_file(app.add_option("--config", options.config,
                              "Settings: a ready configuration or a file, as for 'kfast config'"))
        ->type_name("INPUT")
        ->excludes(panel);
}

void declare_plug(CLI::App& app, SimulateOptions& options)
{
    const OptionHeading heading{app, option_group::device};
    writes_file(
        app.add_option(
            "--socket", options.socket,
            "Where programs reach the board, as --device sim:PATH (default: where --device sim looks)"))
        ->type_name("PATH");
    writes_file(app.add_option(
                    "--flash-file", options.flash,
                    "The file that holds the slots (default: sim-flash.bin among what kfast keeps for you)"))
        ->type_name("FILE");
    app.add_option("--serial", options.serial, "The serial number, of at most 24 letters")
        ->type_name("SERIAL")
        ->check(is_serial)
        ->capture_default_str();
}

void declare_watching(CLI::App& app, SimulateOptions& options)
{
    const OptionHeading heading{app, option_group::showing};
    writes_file(app.add_option("--picture", options.picture, "At the end, write what was shown last as PNG"))
        ->type_name("FILE");
    app.add_flag("--headless", options.headless, "Open no window");
    app.add_flag("--print-frames", options.frames,
                 "Print the events, and each frame shown with the CRC-32 of its pixels");
}

void declare_simulate(CLI::App& app)
{
    const auto options = std::make_shared<SimulateOptions>();
    CLI::Option* const scene =
        app.add_option("SCENE", options->scene,
                       "The built-in scene (.kfast, .kfb or a file to import): plays if no slot is chosen. "
                       "Without it there is a test card");
    reads_file(scene, {".kfb", ".kfast"});
    declare_simulated_panel(app, *options);
    declare_plug(app, *options);
    declare_watching(app, *options);
    app.callback([options] { simulate(*options); });
}

}

const Command simulate_command{"simulate",
                               "Run a board in a window, for --device sim",
                               "kfast simulate --panel gc9a01 &\n"
                               "  kfast play eyes.kfast --device sim",
                               declare_simulate,
                               {},
                               board_group};

}
