#include "host/flash/uf2.hpp"
#include "host/atomic_file.hpp"
#include "host/commands/command.hpp"
#include "host/commands/missing_names.hpp"
#include "host/commands/output_path.hpp"
#include "host/config/config_input.hpp"
#include "host/config/firmware_file.hpp"
#include "host/config/pico_flash.hpp"
#include "host/config/setting_words.hpp"
#include "host/failure.hpp"
#include "host/scene_file.hpp"

#include <array>
#include <iostream>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast {
namespace {

struct Options {
    std::string firmware;
    std::string config;
    std::string scene;
    std::string output;
};

/// What the file is to hold, and that in words.
struct Contents {
    std::vector<FlashRegion> regions;
    std::string words;

    void add(std::uint32_t address, std::vector<std::byte> bytes, const std::string& what)
    {
        words += (words.empty() ? "" : ", ") + what;
        regions.push_back({address, std::move(bytes)});
    }
};

/// Settings for another bus than the firmware's would leave the display dark.
void require_bus(const Options& options, std::span<const std::byte> firmware, BusKind wanted)
{
    const std::optional<BusKind> bus = config::marked_bus(firmware);
    if (!bus)
        std::cerr << options.firmware << ": warning: it does not tell for which bus it is; settings of "
                  << options.config << " want one for " << config::word_of(wanted) << ": "
                  << config::image_of(wanted) << '\n';
    else if (*bus != wanted)
        throw Failure(options.firmware + ": firmware for displays on " + config::word_of(*bus) +
                      ", but the display of " + options.config + " is on " + config::word_of(wanted) +
                      ": take " + config::image_of(wanted));
}

void add_firmware(const std::string& name, Contents& contents)
{
    std::vector<std::byte> bytes = config::load_firmware(name);
    const std::string what = "firmware of " + std::to_string(bytes.size()) + " bytes";
    contents.add(pico_flash::begin, std::move(bytes), what);
}

/// After the firmware, if there is one.
void add_config(const Options& options, const BoardSettings& settings, Contents& contents)
{
    if (!options.firmware.empty())
        require_bus(options, contents.regions.front().bytes, settings.bus);
    contents.add(pico_flash::settings, config::settings_sector(settings), "settings of " + options.config);
}

void add_scene(const std::string& name, SceneFile scene, Contents& contents)
{
    const std::size_t size = scene.bytes.size();
    constexpr std::size_t room = pico_flash::scene_end - pico_flash::scene;
    if (size > room)
        throw Failure(
            name + ": " + std::to_string(size) + " bytes once compiled, " + std::to_string(size - room) +
            " more than a Pico has room for as its built-in scene: shorten the scene or draw it with fewer "
            "points");
    contents.add(pico_flash::scene, std::move(scene.bytes), "scene of " + std::to_string(size) + " bytes");
}

void warn_of_names(const Options& options, const BoardSettings& settings, const SceneView& scene)
{
    for (const std::string& warning : missing_names(settings, scene))
        std::cerr << options.config << ": warning: " << options.scene << ": " << warning << '\n';
}

Contents contents_of(const Options& options)
{
    Contents contents;
    if (!options.firmware.empty())
        add_firmware(options.firmware, contents);
    std::optional<BoardSettings> settings;
    if (!options.config.empty()) {
        settings = config::chosen_settings(options.config);
        add_config(options, *settings, contents);
    }
    if (!options.scene.empty()) {
        SceneFile scene = load_scene(options.scene);
        if (settings)
            warn_of_names(options, *settings, scene.view);
        add_scene(options.scene, std::move(scene), contents);
    }
    return contents;
}

void pack(const Options& options)
{
    if (options.firmware.empty() && options.config.empty() && options.scene.empty())
        throw CLI::RequiredError("one of --firmware, --config and --scene");
    std::filesystem::path output = options.output;
    if (output.extension() != ".uf2")
        throw CLI::ValidationError("--output",
                                   "'" + options.output + "': the drive of a Pico takes .uf2 files alone");
    const Contents contents = contents_of(options);
    for (const std::string* input : {&options.firmware, &options.config, &options.scene})
        output = output_path(output, *input, "file that is read");
    write_file(output, uf2_of(contents.regions));
    std::cout << output.string() << ": " << contents.words
              << "\nHold BOOTSEL while you plug the Pico in, and copy the file to the drive RPI-RP2.\n";
}

void declare_pack(CLI::App& app)
{
    const auto options = std::make_shared<Options>();
    app.add_option("--firmware", options->firmware, "The .bin of a firmware for the Pico")->type_name("FILE");
    app.add_option("--config", options->config, "As for 'kfast config': a ready configuration or a file")
        ->type_name("INPUT");
    app.add_option("--scene", options->scene, "A scene text (.kfast) or compiled scene (.kfb)")
        ->type_name("FILE");
    app.add_option("-o,--output", options->output, "The file to write (.uf2)")->required()->type_name("OUT");
    app.footer("What is left out stays on the Pico as it is.\n\nExample:\n  kfast uf2 pack --firmware "
               "build/pico/pico-spi.bin "
               "--config pico-st7789 --scene eyes.kfast -o eyes.uf2");
    app.callback([options] { pack(*options); });
}

constexpr std::array<std::string_view, 1> subcommands{"pack"};

void declare(CLI::App& app)
{
    declare_pack(*app.add_subcommand("pack", "Put firmware, settings and scene together in one file"));
    app.require_subcommand(1);
}

}

const Command uf2_command{"uf2",
                          "Make the file that is dragged onto the drive of a Pico",
                          "kfast uf2 pack --config pico-st7789 --scene eyes.kfast -o eyes.uf2",
                          declare,
                          subcommands,
                          settings_group};

}
