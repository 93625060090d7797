#pragma once

#include <CLI/CLI.hpp>

namespace kfast {

/// The commands below `kfast uf2`, as Command::declare.
void declare_uf2_pack(CLI::App& app);
void declare_uf2_info(CLI::App& app);
void declare_uf2_unpack(CLI::App& app);

}
