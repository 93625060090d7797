#include "host/config/firmware_images.hpp"

#include "core/bytes/byte_reader.hpp"
#include "firmware/settings/image_mark.hpp"
#include "host/config/pico_flash.hpp"
#include "host/config/setting_words.hpp"
#include "host/file/input_file.hpp"
#include "host/file/program_file.hpp"
#include "host/flash/boot_checksum.hpp"
#include "host/flash/uf2.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <cstdlib>
#include <span>
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

namespace {

constexpr InputKind firmware_input{"firmware", "a .bin file", "build it again"};
constexpr std::size_t boot_code_bytes = 252;

/// The bus that it says it is for, whether there is such a bus or not.
std::optional<std::size_t> bus_number(std::span<const std::byte> image)
{
    if (image.size() < ImageMark::length_place)
        return std::nullopt;
    const auto mark = image.subspan(ImageMark::place, sizeof(ImageMark));
    const auto magic = std::as_bytes(std::span{ImageMark::its_magic});
    if (!std::ranges::equal(mark.first(magic.size()), magic))
        return std::nullopt;
    return std::to_integer<std::size_t>(mark[offsetof(ImageMark, bus)]);
}

void require_whole(std::span<const std::byte> image, const std::string& name)
{
    constexpr std::size_t min = ImageMark::length_place + 4;
    if (image.size() < min)
        throw Failure(name + ": only " + std::to_string(image.size()) +
                      " bytes: it was cut off, copy it again");
    if (!bus_number(image))
        return; // it does not say how long it is
    ByteReader reader{image.subspan(ImageMark::length_place)};
    const std::size_t length = reader.u32();
    if (image.size() != length)
        throw Failure(name + ": " + std::to_string(image.size()) + " bytes instead of " +
                      std::to_string(length) +
                      ": it was cut off, or an older KFAST built it; copy or build it again");
}

}

bool begins_with_boot_block(std::span<const std::byte> bytes)
{
    if (bytes.size() < BootBlock{}.size())
        return false;
    return std::ranges::equal(with_boot_checksum(bytes.first(boot_code_bytes)),
                              bytes.first(BootBlock{}.size()));
}

std::vector<std::byte> load_firmware(const std::filesystem::path& path)
{
    const std::string content = read_input(path, firmware_input);
    if (content.starts_with(uf2_magic))
        throw Failure(path.string() +
                      ": is a UF2 file: name the .bin beside it, or one that kfast uf2 unpack makes of it");
    const auto bytes = std::as_bytes(std::span{content});
    if (!begins_with_boot_block(bytes))
        throw Failure(path.string() +
                      ": does not begin with a boot block of the RP2040: name the .bin file of a "
                      "firmware for the Pico");
    constexpr std::size_t room = pico_flash::settings - pico_flash::begin;
    if (bytes.size() > room)
        throw Failure(path.string() + ": " + std::to_string(bytes.size()) + " bytes, " +
                          std::to_string(bytes.size() - room) +
                          " more than lie before the settings at 0x1003F000",
                      ExitStatus::no_room);
    require_whole(bytes, path.string());
    return {bytes.begin(), bytes.end()};
}

std::optional<BusKind> marked_bus(std::span<const std::byte> image)
{
    const auto number = bus_number(image);
    if (!number || *number >= bus_names.size())
        return std::nullopt;
    return static_cast<BusKind>(*number);
}

}
