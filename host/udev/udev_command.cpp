#include "host/udev/udev_rule.hpp"

#include "host/file/program_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

namespace kfast {
namespace {

namespace fs = std::filesystem;

/// Where sudo looks for programs wherever their folders are not given.
constexpr std::array root_folders{"/usr/local/sbin", "/usr/local/bin", "/usr/sbin",
                                  "/usr/bin",        "/sbin",          "/bin"};

}

std::string udev_command()
{
    const std::optional<fs::path> program = program_file();
    const bool is_found =
        !program || std::ranges::find(root_folders, program->parent_path()) != root_folders.end();
    return "sudo " + (is_found ? "kfast" : program->string()) + " install-udev";
}

}
