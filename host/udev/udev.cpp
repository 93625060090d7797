#include "host/udev/udev.hpp"

#include "host/file/program_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

namespace kfast {

namespace {

namespace fs = std::filesystem;

/// Where sudo looks for programs without a given folder.
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

namespace {

std::string_view line_with(std::string_view text, std::string_view mark)
{
    const std::size_t place = text.find(mark);
    const std::size_t begin = text.rfind('\n', place) + 1;
    return text.substr(begin, text.find('\n', place) - begin);
}

}

Failure not_allowed(const std::string& path, std::string_view mark)
{
    return Failure{"you may not open " + path + ". A rule of udev allows it:\n  " + udev_command() +
                       "\nputs it into /etc/udev/rules.d:\n  " + std::string{line_with(udev_rule, mark)} +
                       "\nThen try again; if that does not help, plug the device in anew",
                   ExitStatus::no_permission};
}

}
