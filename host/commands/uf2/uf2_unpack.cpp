#include "host/commands/options/output_folder.hpp"
#include "host/commands/options/output_option.hpp"
#include "host/commands/options/output_path.hpp"
#include "host/commands/options/report_options.hpp"
#include "host/commands/uf2/uf2_commands.hpp"
#include "host/commands/uf2/uf2_input.hpp"
#include "host/file/atomic_file.hpp"
#include "host/flash/uf2_family.hpp"
#include "host/program/failure.hpp"
#include "host/text/counted.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <string>

namespace kfast {
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
    app.add_option("FILE", options->file, "A UF2 file")->required();
    declare_output(app, options->folder, "The folder to write to; made if need be")
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
