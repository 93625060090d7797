#include "host/commands/command.hpp"
#include "host/commands/uf2/uf2_commands.hpp"

#include <array>
#include <string_view>

namespace kfast {
namespace {

constexpr std::array<std::string_view, 3> subcommands{"pack", "info", "unpack"};

void declare_uf2(CLI::App& app)
{
    declare_uf2_pack(*app.add_subcommand("pack", "Put firmware, settings and scene together in one file"));
    declare_uf2_info(*app.add_subcommand("info", "Tell what a file writes, where, and for which chips"));
    declare_uf2_unpack(*app.add_subcommand("unpack", "Take out what a file writes, as .bin files"));
    app.require_subcommand(1);
}

}

const Command uf2_command{"uf2",
                          "Make and read files that are dragged onto the drive of a Pico",
                          "kfast uf2 pack --config pico-st7789 --scene eyes.kfast -o eyes.uf2",
                          declare_uf2,
                          subcommands,
                          board_group};

}
