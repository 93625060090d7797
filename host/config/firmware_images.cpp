#include "host/config/firmware_images.hpp"

#include "host/config/setting_words.hpp"
#include "host/file/program_file.hpp"
#include "host/program/failure.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

namespace kfast::config {
namespace {

namespace fs = std::filesystem;

bool has_image(const fs::path& folder, BusKind bus)
{
    std::error_code unreadable;
    return fs::is_regular_file(folder / image_name(bus), unreadable);
}

std::string list_of(std::span<const fs::path> folders)
{
    std::string list;
    for (const fs::path& folder : folders)
        list += (list.empty() ? " in " : " and in ") + folder.string();
    return list;
}

}

std::vector<fs::path> image_folders(const char* given, const std::optional<fs::path>& program)
{
    if (given != nullptr && *given != '\0')
        return {given};
    if (!program)
        return {};
    const fs::path above = program->parent_path().parent_path(); // of bin
    return {above / "share/kfast/firmware", above.parent_path() / "pico"};
}

std::vector<fs::path> image_folders() { return image_folders(std::getenv("KFAST_FIRMWARE"), program_file()); }

fs::path image_for(BusKind bus, std::span<const fs::path> folders)
{
    for (const fs::path& folder : folders)
        if (has_image(folder, bus))
            return folder / image_name(bus);
    throw Failure("there is no " + image_name(bus) + list_of(folders) +
                  ": build it with 'scripts/build pico', or name a firmware with --firmware FILE, or the "
                  "folder of all images with KFAST_FIRMWARE=FOLDER; --no-firmware leaves what the board has");
}

std::string image_of(BusKind bus, std::span<const fs::path> folders)
{
    const bool is_installed = !folders.empty() && has_image(folders.front(), bus);
    return ((is_installed ? folders.front() : fs::path{"build/pico"}) / image_name(bus)).string();
}

std::string image_of(BusKind bus) { return image_of(bus, image_folders()); }

}
