#include "host/flash/uf2_drive.hpp"

#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"
#include "tests/host/flash/failure_of.hpp"
#include "tests/host/flash/uf2_rom.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t start = NorFlash::begin;

FlashImage image(unsigned seed)
{
    std::mt19937 random{seed};
    const auto bytes = [&random](std::size_t count) {
        std::vector<std::byte> made(count);
        std::ranges::generate(made, [&random] { return static_cast<std::byte>(random()); });
        return made;
    };
    return FlashImage{std::array{FlashRegion{start, bytes(9000)}, FlashRegion{start + 0x5000, bytes(40)},
                                 FlashRegion{start + 0x6000, bytes(5000)}}};
}

/// A folder that looks like the drive of a Pico.
struct Drive {
    explicit Drive(const std::string& information) { std::ofstream{folder / "INFO_UF2.TXT"} << information; }
    Drive() : Drive{"UF2 Bootloader v3.0\r\nModel: Raspberry Pi RP2\r\nBoard-ID: RPI-RP2\r\n"} {}

    fs::path path() const { return (folder / ".").parent_path(); }
    std::string copied() const { return content(folder / "KFAST.UF2"); }

    TemporaryFolder folder;
};

void ignore(FlashPhase, std::size_t, std::size_t) {}

std::string file_for(const FlashImage& image)
{
    const Drive drive;
    copy_to_drive(uf2_drive_at(drive.path()), image, ignore);
    return drive.copied();
}

/// Whether the first page, by which a board starts, is that of the image.
bool starts(const NorFlash& memory, const FlashImage& image)
{
    return std::ranges::equal(std::span{memory.bytes()}.first(256),
                              std::span{image.sectors()[0].bytes}.first(256));
}

bool holds(const NorFlash& memory, const FlashImage& image)
{
    return std::ranges::all_of(image.sectors(), [&memory](const FlashImage::Sector& sector) {
        return std::ranges::equal(std::span{memory.bytes()}.subspan(sector.address - start, 4096),
                                  sector.bytes);
    });
}

void take(Uf2Rom& rom, std::string_view file, std::size_t blocks)
{
    const auto bytes = std::as_bytes(std::span{file});
    for (std::size_t block = 0; block < blocks; ++block)
        rom.take(bytes.subspan(block * 512, 512));
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}

TEST_CASE("a drive is known by its INFO_UF2.TXT")
{
    const Drive drive;
    CHECK(uf2_drive_at(drive.path()).board == "RPI-RP2");
    CHECK(uf2_drive_at(drive.path()).folder == drive.path());
    const TemporaryFolder empty;
    CHECK(has(failure_of([&] { uf2_drive_at((empty / ".").parent_path()); }, ExitStatus::no_device),
              "Hold BOOTSEL"));
}

TEST_CASE("a drive of another chip is refused")
{
    const Drive other{"UF2 Bootloader v1.0\nModel: Raspberry Pi RP2350\nBoard-ID: RP2350\n"};
    CHECK(has(failure_of([&] { uf2_drive_at(other.path()); }, ExitStatus::wrong_chip), "the board RP2350"));
    const Drive silent{"UF2\n"};
    CHECK(has(failure_of([&] { uf2_drive_at(silent.path()); }, ExitStatus::wrong_chip), "an unknown board"));
}

TEST_CASE("a board has the image once it has had all blocks, and restarts then and not before")
{
    const std::string file = file_for(image(1));
    const std::size_t blocks = file.size() / 512;
    REQUIRE(file.size() % 512 == 0);
    NorFlash memory{12};
    Uf2Rom rom{memory};
    take(rom, file, blocks - 1);
    CHECK_FALSE(rom.has_restarted);
    take(rom, file.substr((blocks - 1) * 512), 1);
    CHECK(rom.has_restarted);
    CHECK(holds(memory, image(1)));
}

TEST_CASE("a board that was unplugged after any block starts nothing or what it had")
{
    const FlashImage old_image = image(1);
    const FlashImage new_image = image(2);
    const std::string file = file_for(new_image);
    NorFlash old_memory{12};
    Uf2Rom old_rom{old_memory};
    take(old_rom, file_for(old_image), file.size() / 512);
    for (std::size_t blocks = 0; blocks < file.size() / 512; ++blocks) {
        CAPTURE(blocks);
        NorFlash memory = old_memory;
        Uf2Rom rom{memory};
        take(rom, file, blocks);
        CHECK((!starts(memory, old_image) || holds(memory, old_image)));
        CHECK_FALSE(starts(memory, new_image));
    }
}

TEST_CASE("another copy after one that was broken off leaves nothing of that")
{
    const FlashImage wanted = image(2);
    const std::string first = file_for(image(1));
    const std::string second = file_for(wanted);
    REQUIRE(first.size() == second.size());
    for (std::size_t blocks = 0; blocks < first.size() / 512; ++blocks) {
        CAPTURE(blocks);
        NorFlash memory{12};
        Uf2Rom rom{memory};
        take(rom, first, blocks);
        for (std::size_t more = 0; more < second.size() / 512; ++more) {
            CHECK_FALSE(starts(memory, wanted));
            take(rom, second.substr(more * 512), 1);
        }
        CHECK(holds(memory, wanted));
        CHECK(rom.has_restarted);
    }
}

TEST_CASE("each step is on the drive before the next one begins")
{
    const Drive drive;
    std::vector<std::uintmax_t> sizes;
    const auto on_progress = [&](FlashPhase phase, std::size_t done, std::size_t total) {
        CHECK(phase == FlashPhase::writing);
        CHECK(total == 7);
        if (done > 0)
            sizes.push_back(fs::file_size(drive.folder / "KFAST.UF2") / 512);
    };
    copy_to_drive(uf2_drive_at(drive.path()), image(1), on_progress);
    CHECK(sizes == std::vector<std::uintmax_t>{32, 48, 64, 80, 96, 112, 128});
}

TEST_CASE("a copy can be interrupted")
{
    const Drive drive;
    const RememberedInterruption interruption;
    const auto on_progress = [](FlashPhase, std::size_t done, std::size_t) {
        if (done == 2)
            std::raise(SIGINT);
    };
    CHECK_THROWS_AS(copy_to_drive(uf2_drive_at(drive.path()), image(1), on_progress), Interrupted);
    CHECK(drive.copied().size() == 48 * 512);
}

TEST_CASE("a drive that is gone or takes nothing is told of")
{
    const Drive drive;
    Uf2Drive found = uf2_drive_at(drive.path());
    found.folder /= "gone";
    CHECK(has(failure_of([&] { copy_to_drive(found, image(1), ignore); }, ExitStatus::unplugged),
              "the board is gone"));
    fs::create_directory(drive.folder / "KFAST.UF2");
    found.folder = drive.path();
    CHECK(has(failure_of([&] { copy_to_drive(found, image(1), ignore); }, ExitStatus::wrong_input),
              "cannot write"));
}

TEST_CASE("an image of nothing is not copied")
{
    const Drive drive;
    copy_to_drive(uf2_drive_at(drive.path()), FlashImage{std::span<const FlashRegion>{}}, ignore);
    CHECK_FALSE(fs::exists(drive.folder / "KFAST.UF2"));
}

}
