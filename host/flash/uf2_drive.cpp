#include "host/flash/uf2_drive.hpp"

#include "host/flash/uf2.hpp"
#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <unistd.h>

namespace kfast {

namespace {

/// FAT, which boot loaders have, by its different drivers. Not memory, as in /tmp, where anybody may create
/// what looks like a drive.
constexpr std::array<std::string_view, 4> file_systems{"vfat", "msdos", "exfat", "fuseblk"};

bool is_octal(char digit) { return digit >= '0' && digit <= '7'; }

/// The kernel writes spaces and the like as a backslash and three octal digits.
std::string unescaped(std::string_view text)
{
    std::string plain;
    while (!text.empty()) {
        const bool is_escape =
            text.size() >= 4 && text[0] == '\\' && std::ranges::all_of(text.substr(1, 3), is_octal);
        plain += is_escape ? static_cast<char>((text[1] - '0') * 64 + (text[2] - '0') * 8 + (text[3] - '0'))
                           : text[0];
        text.remove_prefix(is_escape ? 4 : 1);
    }
    return plain;
}

}

std::vector<std::filesystem::path> mounted_folders(std::string_view mountinfo)
{
    std::vector<std::filesystem::path> folders;
    std::istringstream lines{std::string{mountinfo}};
    for (std::string line; std::getline(lines, line);) {
        // mount, parent, device, root, folder, options, further fields, "-", file system, …
        std::istringstream words{line};
        std::string word;
        std::string folder;
        for (int field = 0; field < 5; ++field)
            words >> folder;
        while (words >> word && word != "-") {
        }
        if (words >> word && std::ranges::find(file_systems, word) != file_systems.end())
            folders.emplace_back(unescaped(folder));
    }
    return folders;
}

// How the boot ROM of the RP2040 handles blocks, by its published sources (raspberrypi/pico-bootrom-rp2040,
// bootrom/virtual_disk.c): it erases the sector of an address when the first block arrives of those whose
// numbers are 16 n to 16 n + 15, leaves out a number that it has had, begins anew when the count changes or a
// block says that there are none, and restarts the board when it has had all numbers. Nothing it does depends
// on their order, or on their positions in the file.

namespace {

namespace fs = std::filesystem;

constexpr const char* rp2040_board = "RPI-RP2";
constexpr std::size_t longest_information = 4096;

std::optional<std::string> information_of(const fs::path& folder)
{
    for (const char* const name : {"INFO_UF2.TXT", "info_uf2.txt"}) {
        std::ifstream file{folder / name, std::ios::binary};
        std::string text(longest_information, '\0');
        if (!file.read(text.data(), static_cast<std::streamsize>(text.size())) && file.gcount() == 0)
            continue;
        text.resize(static_cast<std::size_t>(file.gcount()));
        return text;
    }
    return std::nullopt;
}

/// The text after "Board-ID: "; none if there is no such line.
std::string board_in(std::string_view information)
{
    constexpr std::string_view label = "Board-ID: ";
    const std::size_t place = information.find(label);
    if (place == std::string_view::npos)
        return {};
    const std::string_view rest = information.substr(place + label.size());
    return std::string{rest.substr(0, rest.find_first_of("\r\n"))};
}

std::optional<Uf2Drive> drive_in(const fs::path& folder)
{
    const auto information = information_of(folder);
    return information ? std::optional{Uf2Drive{folder, board_in(*information)}} : std::nullopt;
}

[[noreturn]] void fail(const fs::path& path, int error)
{
    const std::string reason = "cannot write " + path.string() + ": " + std::strerror(error) + ": ";
    switch (error) {
    case EACCES:
    case EPERM:
    case EROFS:
        throw Failure{reason + "mount the drive so that you may write to it", ExitStatus::no_permission};
    case EIO:
    case ENODEV:
    case ENXIO:
    case ENOENT:
    case ENOTDIR:
        throw Failure{reason + "the board is gone: plug it in with BOOTSEL held down, and flash it again",
                      ExitStatus::unplugged};
    default:
        throw Failure{reason + "plug the board in anew with BOOTSEL held down, and flash it again"};
    }
}

/// A file whose bytes are on the drive when write() returns.
class SteadyFile {
public:
    explicit SteadyFile(const fs::path& path)
        : path_{path}, descriptor_{::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)}
    {
        if (descriptor_ < 0)
            fail(path, errno);
    }
    ~SteadyFile() { ::close(descriptor_); }
    SteadyFile(const SteadyFile&) = delete;
    SteadyFile& operator=(const SteadyFile&) = delete;

    void write(std::span<const std::byte> bytes)
    {
        write_to_cache(bytes);
        while (::fsync(descriptor_) != 0)
            if (errno != EINTR)
                fail(path_, errno);
    }

    /// A board that restarts may be gone before it acknowledges them.
    void write_last(std::span<const std::byte> bytes)
    {
        write_to_cache(bytes);
        ::fsync(descriptor_);
    }

private:
    void write_to_cache(std::span<const std::byte> bytes)
    {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno != EINTR)
                fail(path_, errno);
            bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
        }
    }

    fs::path path_;
    int descriptor_;
};

/// 16 blocks each: whole pages of the computer's memory, which it would write once more if a later step were
/// to fill them up.
class Steps {
public:
    explicit Steps(const FlashImage& image)
        : numbered_{.count = static_cast<std::uint32_t>((image.sectors().size() + 1) * Uf2Block::per_sector),
                    .family = rp2040_family}
    {
    }

    /// Ends what an interrupted copy may have begun.
    std::vector<std::byte> forgetting()
    {
        constexpr std::array<std::byte, Uf2Block::payload_size> nothing{};
        ByteWriter step;
        for (std::size_t block = 0; block < Uf2Block::per_sector; ++block)
            write_uf2_block(step, {.family = rp2040_family, .payload = nothing});
        return step.bytes();
    }

    std::vector<std::byte> blanking(const FlashImage::Sector& sector)
    {
        FlashImage::Sector blank{sector.address, {}};
        blank.bytes.fill(std::byte{0xFF});
        return writing(blank);
    }

    std::vector<std::byte> writing(const FlashImage::Sector& sector)
    {
        ByteWriter step;
        write_uf2_sector(step, sector, numbered_);
        numbered_.number += Uf2Block::per_sector;
        return step.bytes();
    }

    /// Its first page comes last: once a board has that, it starts.
    std::vector<std::byte> completing(const FlashImage::Sector& sector)
    {
        std::vector<std::byte> step = writing(sector);
        std::rotate(step.begin(), step.begin() + Uf2Block::bytes, step.end());
        return step;
    }

private:
    Uf2Block numbered_; ///< the beginning of the next sector
};

}

std::vector<Uf2Drive> uf2_drives()
{
    std::ifstream mountinfo{"/proc/self/mountinfo"};
    const std::string mounts{std::istreambuf_iterator<char>{mountinfo}, {}};
    std::vector<Uf2Drive> drives;
    for (const fs::path& folder : mounted_folders(mounts))
        if (const auto drive = drive_in(folder))
            drives.push_back(*drive);
    return drives;
}

Uf2Drive uf2_drive_at(const fs::path& folder)
{
    const auto drive = drive_in(folder);
    if (!drive)
        throw Failure{folder.string() +
                          " is no drive of a boot loader: it has no INFO_UF2.TXT. Hold BOOTSEL while "
                          "you plug the board in, and name the folder where its drive is mounted",
                      ExitStatus::no_device};
    if (drive->board != rp2040_board)
        throw Failure{folder.string() + " is the drive of " +
                          (drive->board.empty() ? "an unknown board" : "the board " + drive->board) +
                          ", and the firmware is for the RP2040, whose drive says " + rp2040_board,
                      ExitStatus::wrong_chip};
    return *drive;
}

void copy_to_drive(const Uf2Drive& drive, const FlashImage& image, const FlashProgressCallback& on_progress)
{
    const auto sectors = image.sectors();
    if (sectors.empty())
        return;
    const std::size_t total = sectors.size() + 1;
    const auto begin = [&](std::size_t done) {
        on_progress(FlashPhase::writing, done, total);
        heed_interruption();
    };

    begin(0);
    SteadyFile file{drive.folder / "KFAST.UF2"};
    Steps steps{image};
    file.write(steps.forgetting());
    file.write(steps.blanking(sectors.front()));
    for (std::size_t index = 1; index < sectors.size(); ++index) {
        begin(index);
        file.write(steps.writing(sectors[index]));
    }
    begin(sectors.size());
    file.write_last(steps.completing(sectors.front()));
    on_progress(FlashPhase::writing, total, total);
}

}
