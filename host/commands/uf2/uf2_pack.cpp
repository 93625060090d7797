#include "host/commands/flash/flash_contents.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/options/offered_names.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/output_option.hpp"
#include "host/commands/options/output_path.hpp"
#include "host/commands/options/report_options.hpp"
#include "host/commands/uf2/uf2_commands.hpp"
#include "host/compile/scene_file.hpp"
#include "host/config/config_input.hpp"
#include "host/config/configurations.hpp"
#include "host/config/firmware_file.hpp"
#include "host/file/atomic_file.hpp"
#include "host/flash/uf2.hpp"
#include "host/program/failure.hpp"

#include <iostream>
#include <optional>
#include <string>

namespace kfast {
namespace {

struct Uf2PackOptions {
    std::string firmware;
    std::string config;
    std::string scene;
    std::string output;
    bool quiet = false;
};

FlashContents contents_of(const Uf2PackOptions& options)
{
    std::optional<NamedFirmware> firmware;
    if (!options.firmware.empty())
        firmware = {config::load_firmware(options.firmware), options.firmware};
    std::optional<NamedSettings> settings;
    if (!options.config.empty())
        settings = {config::chosen_settings(options.config), options.config};
    std::optional<SceneFile> scene;
    if (!options.scene.empty())
        scene.emplace(load_scene(options.scene));
    const auto part = [](auto& chosen) { return chosen ? &*chosen : nullptr; };
    return flash_contents({part(firmware), part(settings), part(scene), options.scene});
}

void pack(const Uf2PackOptions& options)
{
    if (options.firmware.empty() && options.config.empty() && options.scene.empty())
        throw CLI::RequiredError("one of --firmware, --config and --scene");
    std::filesystem::path output = options.output;
    if (output.extension() != ".uf2")
        throw CLI::ValidationError("--output",
                                   "'" + options.output + "': the drive of a Pico takes .uf2 files alone");
    const FlashContents contents = contents_of(options);
    for (const std::string* input : {&options.firmware, &options.config, &options.scene})
        output = output_path(output, *input, "file that is read");
    write_file(output, uf2_of(contents.regions));
    report_stream(options.quiet)
        << output.string() << ": " << contents.words
        << "\nHold BOOTSEL while you plug the Pico in, and copy the file to the drive RPI-RP2.\n";
}

}

void declare_uf2_pack(CLI::App& app)
{
    const OptionHeading heading{app, option_group::contents};
    const auto options = std::make_shared<Uf2PackOptions>();
    app.add_option("--firmware", options->firmware, "The .bin of a firmware for the Pico")->type_name("FILE");
    CLI::Option* const config =
        app.add_option("--config", options->config,
                       "Settings: a ready configuration or a file, as for 'kfast config'")
            ->type_name("INPUT");
    offer_names(config, config::configurations());
    app.add_option("--scene", options->scene, loaded_scene)->type_name("FILE");
    declare_output(app, options->output, "The file to write (.uf2)")->required();
    declare_quiet(app, options->quiet);
    app.footer("What is left out stays on the Pico as it is.\n\nExample:\n  kfast uf2 pack --firmware "
               "build/pico/pico-spi.bin "
               "--config pico-st7789 --scene eyes.kfast -o eyes.uf2");
    app.callback([options] { pack(*options); });
}

}
