#include "host/flash/boot_board.hpp"
#include "host/flash/flashing.hpp"
#include "host/flash/uf2_drive.hpp"
#include "host/program/failure.hpp"
#include "tests/demand.hpp"
#include "tests/fuzz/input.hpp"
#include "tests/host/flash/pretend_libusb.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <libusb-1.0/libusb.h>
#include <span>
#include <string>
#include <string_view>
#include <vector>

using namespace kfast;
using namespace kfast::test;

namespace {

constexpr std::size_t sectors = 4;

std::vector<std::byte> pattern(std::size_t count, std::uint32_t seed)
{
    std::vector<std::byte> bytes(count);
    std::ranges::generate(bytes, [&seed] {
        seed = seed * 1664525 + 1013904223;
        return static_cast<std::byte>(seed >> 24);
    });
    return bytes;
}

FlashImage image(std::uint32_t seed)
{
    return FlashImage{
        std::array{FlashRegion{NorFlash::begin, pattern(5000, seed)},
                   FlashRegion{NorFlash::begin + 3 * NorFlash::sector_bytes, pattern(40, seed)}}};
}

NorFlash memory_with(const FlashImage& image)
{
    NorFlash memory{sectors};
    for (const FlashImage::Sector& sector : image.sectors())
        std::ranges::copy(sector.bytes, memory.bytes().begin() + (sector.address - NorFlash::begin));
    return memory;
}

bool holds(const NorFlash& memory, const FlashImage::Sector& sector, std::size_t bytes)
{
    const auto there = std::span{memory.bytes()}.subspan(sector.address - NorFlash::begin, bytes);
    return std::ranges::equal(there, std::span{sector.bytes}.first(bytes));
}

bool holds(const NorFlash& memory, const FlashImage& image)
{
    return std::ranges::all_of(image.sectors(), [&](const FlashImage::Sector& sector) {
        return holds(memory, sector, sector.bytes.size());
    });
}

/// Whether the first page is there, by which a board starts, without all the rest.
bool starts_half(const NorFlash& memory, const FlashImage& image)
{
    return holds(memory, image.sectors().front(), FlashImage::page_bytes) && !holds(memory, image);
}

/// What is plugged in, and what it answers, by the bytes of the fuzzer.
class AnyBoards {
public:
    explicit AnyBoards(FuzzInput& input) : input_{input}
    {
        const std::uint8_t how = input_.u8();
        says_anything_ = (how & 1) != 0;
        has_old_image_ = (how & 2) != 0;
        plugged_in.clear();
        for (std::uint8_t count = 1 + input_.below(3); count > 0; --count)
            plugged_in.push_back(any_board());
        changed_transfer = [this](bool is_in, std::span<std::byte> bytes, const auto& by_rom) {
            return says_anything_ ? anything(is_in, bytes) : changed(by_rom);
        };
    }
    ~AnyBoards() { changed_transfer = {}; }
    AnyBoards(const AnyBoards&) = delete;
    AnyBoards& operator=(const AnyBoards&) = delete;

    void flash()
    {
        for (const BootBoard& board : boards_in_boot_loader())
            flash(board);
        demand(libusb_things_in_use == 0);
    }

private:
    int any_error() { return -1 - input_.below(12); } // those of libusb

    PluggedIn any_board()
    {
        PluggedIn board;
        board.rom = &rom_;
        const std::uint8_t what = input_.u8();
        if ((what & 1) != 0)
            board.product = input_.flag() ? std::uint16_t{0x000f} : input_.u16();
        if ((what & 2) != 0)
            board.vendor = input_.u16();
        if ((what & 4) != 0)
            board.ports = any_ports();
        if ((what & 8) != 0)
            board.interfaces = any_interfaces();
        if ((what & 16) != 0)
            board.configuration_error = any_error();
        if ((what & 32) != 0)
            board.open_error = any_error();
        if ((what & 64) != 0)
            board.claim_error = any_error();
        if ((what & 128) != 0)
            board.transfer_error = any_error();
        return board;
    }

    /// Too deep, too, which is an error of libusb.
    std::vector<std::uint8_t> any_ports()
    {
        std::vector<std::uint8_t> ports(input_.below(10));
        std::ranges::generate(ports, [this] { return input_.u8(); });
        return ports;
    }

    std::vector<PretendInterface> any_interfaces()
    {
        std::vector<PretendInterface> interfaces(input_.below(4));
        for (PretendInterface& interface : interfaces) {
            interface.kind = input_.flag() ? std::uint8_t{LIBUSB_CLASS_VENDOR_SPEC} : input_.u8();
            interface.has_setting = input_.u8() % 8 != 0;
            interface.endpoints.resize(input_.below(4));
            for (auto& [address, attributes] : interface.endpoints) {
                address = input_.u8();
                attributes = input_.u8() % 4 == 0 ? input_.u8() : std::uint8_t{LIBUSB_TRANSFER_TYPE_BULK};
            }
        }
        return interfaces;
    }

    /// As the ROM answers, or with an error before it has heard of it, or after that.
    int changed(const std::function<int()>& by_rom)
    {
        const std::uint8_t how = input_.u8();
        if (how == 0xFF)
            return any_error();
        const int result = by_rom();
        return how == 0xFE ? any_error() : result;
    }

    int anything(bool is_in, std::span<std::byte> bytes)
    {
        const std::uint8_t how = input_.u8();
        if (how >= 0xF0)
            return any_error();
        if (!is_in)
            return static_cast<int>(bytes.size());
        const std::size_t count =
            how < 0x80 ? bytes.size() : std::min<std::size_t>(input_.u8(), bytes.size());
        std::ranges::fill(bytes.first(count), std::byte{0xFF}); // as erased flash
        std::ranges::copy(input_.take(std::min<std::size_t>(how % 16, count)), bytes.begin());
        return input_.at_end() ? 0 : static_cast<int>(count);
    }

    /// Unless it says what is not so, flash holds what is said to be written, and a board starts nothing that
    /// is not whole.
    void flash(const BootBoard& board)
    {
        bool is_done = false;
        memory_ = has_old_image_ ? memory_with(old_image_) : NorFlash{sectors};
        try {
            const auto boot_loader = open_boot_loader(board);
            write_sectors(*boot_loader, image_, differing_sectors(*boot_loader, image_, ignore), ignore);
            verify(*boot_loader, image_, ignore);
            is_done = true;
            boot_loader->restart();
        } catch (const Failure& failure) {
            demand(failure.status() != ExitStatus::done && failure.what()[0] != '\0');
        }
        if (!says_anything_)
            demand((!is_done || holds(memory_, image_)) && !starts_half(memory_, image_) &&
                   !starts_half(memory_, old_image_));
    }

    static void ignore(FlashPhase, std::size_t done, std::size_t total) { demand(done <= total); }

    FuzzInput& input_;
    bool says_anything_ = false; ///< instead of what a ROM would
    bool has_old_image_ = false;
    FlashImage old_image_ = image(1);
    FlashImage image_ = image(2);
    NorFlash memory_{sectors};
    BootRom rom_{memory_};
};

void look_at_drive(FuzzInput& input)
{
    static const TemporaryFolder folder;
    const auto text = input.take(10'000);
    std::ofstream{folder / "INFO_UF2.TXT", std::ios::binary}.write(reinterpret_cast<const char*>(text.data()),
                                                                   static_cast<std::streamsize>(text.size()));
    try {
        demand(uf2_drive_at(folder / "").board == "RPI-RP2");
    } catch (const Failure& failure) {
        demand(failure.status() == ExitStatus::wrong_chip || failure.status() == ExitStatus::no_device);
        demand(failure.what()[0] != '\0');
    }
}

void look_for_drives(FuzzInput& input)
{
    const auto text = input.take(10'000);
    const std::string_view mounts{reinterpret_cast<const char*>(text.data()), text.size()};
    const auto lines = static_cast<std::size_t>(std::ranges::count(mounts, '\n')) + 1;
    demand(mounted_folders(mounts).size() <= lines);
}

}

/// Whatever boot loaders, their drives and the mounts say: flashing comes to an end, well, or with a Failure.
/// The first byte says which of them is looked at.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    FuzzInput input{std::as_bytes(std::span{data, size})};
    switch (input.below(4)) {
    case 0:
        look_at_drive(input);
        break;
    case 1:
        look_for_drives(input);
        break;
    default:
        AnyBoards{input}.flash();
        break;
    }
    return 0;
}
