#include "host/commands/uf2/uf2_commands.hpp"

#include "host/commands/flash/flash_contents.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/commands/uf2/uf2_input.hpp"
#include "host/compile/scene_file.hpp"
#include "host/config/config_input.hpp"
#include "host/config/configurations.hpp"
#include "host/config/firmware_images.hpp"
#include "host/file/atomic_file.hpp"
#include "host/flash/flash_image.hpp"
#include "host/flash/uf2.hpp"
#include "host/flash/uf2_family.hpp"
#include "host/program/failure.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
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
    reads_file(app.add_option("--firmware", options->firmware, "The .bin of a firmware for the Pico"),
               {".bin"})
        ->type_name("FILE");
    CLI::Option* const config =
        app.add_option("--config", options->config,
                       "Settings: a ready configuration or a file, as for 'kfast config'")
            ->type_name("INPUT");
    offer_names(reads_file(config), config::configurations());
    reads_scene(app.add_option("--scene", options->scene, loaded_scene))->type_name("FILE");
    declare_output(app, options->output, "The file to write (.uf2)")->required();
    declare_quiet(app, options->quiet);
    app.footer("What is left out stays on the Pico as it is.\n\nExample:\n  kfast uf2 pack --firmware "
               "build/pico/pico-spi.bin "
               "--config pico-st7789 --scene eyes.kfast -o eyes.uf2");
    app.callback([options] { pack(*options); });
}

namespace {

using Json = nlohmann::ordered_json;

struct Uf2InfoOptions {
    std::string file;
    bool json = false;
};

struct BlockFlag {
    std::uint32_t bit;
    const char* name;
};

constexpr std::array flags{BlockFlag{0x0001, "not-for-flash"}, BlockFlag{0x1000, "stored-file"},
                           BlockFlag{0x2000, "family"}, BlockFlag{0x4000, "checksum"},
                           BlockFlag{0x8000, "tags"}};

std::vector<std::string> flag_names(std::uint32_t set)
{
    std::vector<std::string> names;
    for (const auto& [bit, name] : flags)
        if ((set & bit) != 0)
            names.emplace_back(name);
    return names;
}

std::size_t bytes_of(const Uf2Part& part)
{
    std::size_t bytes = 0;
    for (const FlashRegion& region : part.regions)
        bytes += region.bytes.size();
    return bytes;
}

void print_part(const Uf2Part& part)
{
    std::cout << "  for " << chips_of(part) << ": " << counted(part.blocks, "block") << ", "
              << counted(bytes_of(part), "byte");
    for (const std::string& name : flag_names(part.flags))
        std::cout << (name == "family" ? "" : ", " + name);
    std::cout << '\n';
    for (const auto& [region, words] : pieces_of(part))
        std::cout << "    " << hex_text(region.address) << "  " << counted(region.bytes.size(), "byte")
                  << (words.empty() ? "" : "  " + words) << '\n';
}

/// Null if it is not known.
Json words_json(std::string_view words) { return words.empty() ? Json(nullptr) : Json(words); }

Json json_of(const Uf2Part& part)
{
    Json regions = Json::array();
    for (const auto& [region, words] : pieces_of(part))
        regions.push_back(
            {{"address", region.address}, {"bytes", region.bytes.size()}, {"holds", words_json(words)}});
    return {{"family", part.family ? Json(*part.family) : Json(nullptr)},
            {"chips", words_json(part.family ? uf2_family_name(*part.family) : "")},
            {"flags", flag_names(part.flags)},
            {"blocks", part.blocks},
            {"bytes", bytes_of(part)},
            {"regions", regions}};
}

void inform(const Uf2InfoOptions& options)
{
    const Uf2Contents contents = load_uf2(options.file);
    if (options.json) {
        Json parts = Json::array();
        for (const Uf2Part& part : contents.parts)
            parts.push_back(json_of(part));
        std::cout << json_text({{"file", options.file}, {"blocks", contents.blocks}, {"parts", parts}});
        return;
    }
    std::cout << options.file << ": " << counted(contents.blocks, "block") << '\n';
    for (const Uf2Part& part : contents.parts)
        print_part(part);
}

}

void declare_uf2_info(CLI::App& app)
{
    const auto options = std::make_shared<Uf2InfoOptions>();
    reads_file(app.add_option("FILE", options->file, "A UF2 file"))->required();
    declare_json(app, options->json);
    app.footer("Example:\n  kfast uf2 info eyes.uf2");
    app.callback([options] { inform(*options); });
}

namespace {

namespace fs = std::filesystem;

struct Uf2UnpackOptions {
    std::string file;
    std::string folder;
    std::string family;
    bool quiet = false;
};

/// "  RP2040 (0xe48bff56)" and so on, for messages.
std::string list_of(const std::vector<Uf2Part>& parts)
{
    std::string list;
    for (const Uf2Part& part : parts)
        list += "\n  " + chips_of(part);
    return list;
}

const Uf2Part& only_part(const Uf2UnpackOptions& options, const std::vector<Uf2Part>& parts)
{
    if (parts.size() > 1)
        throw Failure{options.file + " is for several families of chips: choose one with --family" +
                          list_of(parts),
                      ExitStatus::wrong_usage};
    return parts.front();
}

const Uf2Part& chosen_part(const Uf2UnpackOptions& options, const std::vector<Uf2Part>& parts)
{
    if (options.family.empty())
        return only_part(options, parts);
    const auto family = uf2_family_called(options.family);
    if (!family)
        throw CLI::ValidationError("--family", "'" + options.family +
                                                   "' is neither the name of a family of chips nor a number "
                                                   "like 0xe48bff56");
    const auto found = std::ranges::find(parts, family, &Uf2Part::family);
    if (found == parts.end())
        throw Failure{options.file + " has nothing for " + options.family + ", but for" + list_of(parts)};
    return *found;
}

/// "eyes-10040000.bin"
fs::path name_of(const Uf2UnpackOptions& options, std::uint32_t address)
{
    std::array<char, 16> digits{};
    std::snprintf(digits.data(), digits.size(), "%08x", static_cast<unsigned>(address));
    return fs::path{options.file}.stem().string() + "-" + digits.data() + ".bin";
}

void unpack(const Uf2UnpackOptions& options)
{
    const Uf2Contents contents = load_uf2(options.file);
    const std::vector<FlashPiece> pieces = pieces_of(chosen_part(options, contents.parts));
    const fs::path folder = options.folder;
    make_output_folder(folder);
    for (const auto& [region, words] : pieces) {
        const fs::path file =
            output_path(folder / name_of(options, region.address), options.file, "file itself");
        write_file(file, region.bytes);
        report_stream(options.quiet) << file.string() << ": " << counted(region.bytes.size(), "byte")
                                     << (words.empty() ? "" : ", " + words) << '\n';
    }
}

}

void declare_uf2_unpack(CLI::App& app)
{
    const auto options = std::make_shared<Uf2UnpackOptions>();
    reads_file(app.add_option("FILE", options->file, "A UF2 file"))->required();
    names_folder(declare_output(app, options->folder, "The folder to write to; made if need be"))
        ->required()
        ->type_name("FOLDER");
    app.add_option("--family", options->family, "Of a file for several kinds of chips: rp2040 or 0xe48bff56")
        ->type_name("FAMILY");
    declare_quiet(app, options->quiet);
    app.footer(
        "Writes a .bin for each region, named by its address; firmware, settings and scenes of KFAST come\n"
        "in files of their own, without padding.\n\nExample:\n  kfast uf2 unpack eyes.uf2 -o eyes");
    app.callback([options] { unpack(*options); });
}

}
