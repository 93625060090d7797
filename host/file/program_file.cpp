#include "host/file/program_file.hpp"

#include <cerrno>
#include <string>
#include <system_error>

namespace kfast {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> executable_file()
{
    std::error_code unknown;
    fs::path file = fs::read_symlink("/proc/self/exe", unknown);
    return unknown ? std::nullopt : std::optional{std::move(file)};
}

/// Decides by its name: ld.so in the tar, else as ld-linux-x86-64.so.2.
bool is_loader(const fs::path& file)
{
    const std::string name = file.filename().string();
    return name == "ld.so" || name.starts_with("ld-");
}

}

std::optional<fs::path> program_file(const std::optional<fs::path>& executable, const fs::path& invocation)
{
    if (executable && !is_loader(*executable))
        return executable;
    return invocation.is_absolute() ? std::optional{invocation} : std::nullopt;
}

std::optional<fs::path> program_file() { return program_file(executable_file(), program_invocation_name); }

bool has_own_libraries()
{
    const std::optional<fs::path> executable = executable_file();
    return executable && is_loader(*executable);
}

}
