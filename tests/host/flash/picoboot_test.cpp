#include "host/flash/picoboot.hpp"

#include "host/flash/flashing.hpp"
#include "tests/bytes.hpp"
#include "tests/host/flash/boot_rom.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::uint32_t start = NorFlash::begin;

std::unique_ptr<PicobootLoader> opened(BootRom& rom)
{
    return std::make_unique<PicobootLoader>(std::make_unique<BootRomPipe>(rom));
}

std::vector<std::byte> counted_bytes(std::size_t count, int first)
{
    std::vector<std::byte> bytes(count);
    for (std::size_t at = 0; at < count; ++at)
        bytes[at] = static_cast<std::byte>(first + static_cast<int>(at * 7));
    return bytes;
}

void ignore(FlashPhase, std::size_t, std::size_t) {}

void flash(BootRom& rom, const FlashImage& image)
{
    const auto boot_loader = opened(rom);
    write_sectors(*boot_loader, image, differing_sectors(*boot_loader, image, ignore), ignore);
    boot_loader->restart();
}

std::string refusal_of(const auto& action)
{
    try {
        action();
    } catch (const Failure& failure) {
        CHECK(failure.status() == ExitStatus::refused);
        return failure.what();
    }
    FAIL("nothing was thrown");
    return {};
}

/// One of which a transfer gets lost: the ROM has made it, and the computer does not hear of that.
class DeafPipe final : public UsbPipe {
public:
    explicit DeafPipe(BootRom& rom) : pipe_{rom} {}

    void send(std::span<const std::byte> bytes, std::chrono::milliseconds patience) override
    {
        pipe_.send(bytes, patience);
        lose();
    }
    std::size_t receive(std::span<std::byte> bytes, std::chrono::milliseconds patience) override
    {
        const std::size_t count = pipe_.receive(bytes, patience);
        lose();
        return count;
    }
    void control_write(std::uint8_t request, std::chrono::milliseconds patience) override
    {
        pipe_.control_write(request, patience);
    }
    std::size_t ask(std::uint8_t request, std::span<std::byte> answer,
                    std::chrono::milliseconds patience) override
    {
        return pipe_.ask(request, answer, patience);
    }
    void clear_halts() override { pipe_.clear_halts(); }

    int until_lost = std::numeric_limits<int>::max(); ///< so many transfers of bulk endpoints

private:
    void lose()
    {
        if (until_lost-- == 0)
            throw Failure{"lost", ExitStatus::timed_out};
    }

    BootRomPipe pipe_;
};

}

TEST_CASE("flash is read, erased and written")
{
    NorFlash memory{4};
    BootRom rom{memory};
    const auto boot_loader = opened(rom);
    const auto bytes = counted_bytes(4096, 3);
    boot_loader->write(start + 4096, bytes);
    std::vector<std::byte> found(4096);
    boot_loader->read(start + 4096, found);
    CHECK(found == bytes);
    boot_loader->erase(start + 4096, 2 * 4096);
    boot_loader->read(start + 4096, found);
    CHECK(found == std::vector<std::byte>(4096, std::byte{0xFF}));
}

TEST_CASE("the drive takes nothing while flash is written, and is there again afterwards")
{
    NorFlash memory{1};
    BootRom rom{memory};
    auto boot_loader = opened(rom);
    CHECK(rom.exclusive == 1);
    boot_loader.reset();
    CHECK(rom.exclusive == 0);
    CHECK_FALSE(rom.is_ejected);
    CHECK_FALSE(rom.restart);
}

TEST_CASE("a restart is one from flash, with the drive ejected")
{
    for (const bool goes_at_once : {false, true}) {
        NorFlash memory{1};
        BootRom rom{memory};
        rom.goes_at_once = goes_at_once;
        opened(rom)->restart();
        REQUIRE(rom.restart);
        CHECK(*rom.restart == std::array<std::uint32_t, 3>{0, 0x2004'2000, 500});
        CHECK(rom.is_ejected);
    }
}

TEST_CASE("what another program has left unfinished does no harm")
{
    NorFlash memory{2};
    BootRom rom{memory};
    SUBCASE("halted endpoints") { rom.send(bytes({1, 2, 3})); }
    SUBCASE("a command without its data")
    {
        rom.has_left_xip = true;
        rom.send(bytes({0x0B, 0xD1, 0x1F, 0x43, 9, 0, 0, 0, 5, 8, 0, 0, 0, 1, 0, 0,
                        0,    0,    0,    0x10, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    }
    SUBCASE("an answer that nobody has fetched")
    {
        rom.has_left_xip = true;
        rom.send(bytes({0x0B, 0xD1, 0x1F, 0x43, 9, 0, 0, 0, 0x84, 8, 0, 0, 0, 1, 0, 0,
                        0,    0,    0,    0x10, 0, 1, 0, 0, 0,    0, 0, 0, 0, 0, 0, 0}));
    }
    const FlashImage image{std::array{FlashRegion{start, counted_bytes(5000, 1)}}};
    flash(rom, image);
    CHECK(std::ranges::equal(std::span{memory.bytes()}.first(5000), counted_bytes(5000, 1)));
}

TEST_CASE("what the boot loader refuses is told in words, and it is of use again")
{
    NorFlash memory{2};
    BootRom rom{memory};
    const auto boot_loader = opened(rom);
    std::array<std::byte, 256> page{};
    CHECK(refusal_of([&] { boot_loader->read(0x2000'0000, page); }) ==
          "the boot loader refuses to read flash at 0x20000000: it has no memory there: what is flashed "
          "belongs "
          "to another board");
    CHECK(refusal_of([&] { boot_loader->write(start + 1, page); }) ==
          "the boot loader refuses to write to flash at 0x10000001: that is a mistake of kfast, please "
          "report it");
    rom.next_status = 6;
    CHECK(
        refusal_of([&] { boot_loader->write(start, page); }) ==
        "the boot loader refuses to write to flash at 0x10000000: another program wrote to the drive of the "
        "board meanwhile: end that, and try again");
    rom.next_status = 77;
    CHECK(refusal_of([&] { boot_loader->write(start, page); }).find("status 77") != std::string::npos);
    rom.next_status.reset();
    boot_loader->write(start, page);
    CHECK(memory.bytes()[0] == std::byte{});
}

TEST_CASE(
    "after a transfer that got lost, the next command finds the boot loader ready, and nobody else writes")
{
    for (int lost = 0; lost < 3; ++lost)
        for (const bool reads : {true, false}) {
            NorFlash memory{2};
            BootRom rom{memory};
            auto pipe = std::make_unique<DeafPipe>(rom);
            DeafPipe& deaf = *pipe;
            PicobootLoader boot_loader{std::move(pipe)};
            std::vector<std::byte> page = counted_bytes(256, 5);
            deaf.until_lost = lost;
            const auto use = [&] { reads ? boot_loader.read(start, page) : boot_loader.write(start, page); };
            CHECK_THROWS_WITH(use(), "lost");
            boot_loader.erase(start, 4096);
            CHECK(rom.exclusive == 1);
            boot_loader.read(start, page);
            CHECK(page == std::vector<std::byte>(256, std::byte{0xFF}));
        }
}

TEST_CASE("after a restart that got lost, the boot loader is there as before")
{
    for (int lost = 0; lost < 4; ++lost) {
        CAPTURE(lost);
        NorFlash memory{2};
        BootRom rom{memory};
        auto pipe = std::make_unique<DeafPipe>(rom);
        DeafPipe& deaf = *pipe;
        PicobootLoader boot_loader{std::move(pipe)};
        deaf.until_lost = lost;
        CHECK_THROWS_WITH(boot_loader.restart(), "lost");
        boot_loader.erase(start, 4096);
        CHECK(rom.exclusive == 1);
    }
}

TEST_CASE(
    "a board that was unplugged after any step starts nothing or what it had, and a second run repairs it")
{
    const FlashImage old_image{std::array{FlashRegion{start, counted_bytes(9000, 1)}}};
    const FlashImage new_image{std::array{FlashRegion{start, counted_bytes(9000, 2)}}};
    const auto begins = [](const NorFlash& memory, const FlashImage& image) {
        return std::ranges::equal(std::span{memory.bytes()}.first(256),
                                  std::span{image.sectors()[0].bytes}.first(256));
    };
    const auto holds = [](const NorFlash& memory, const FlashImage& image) {
        return std::ranges::all_of(image.sectors(), [&memory](const FlashImage::Sector& sector) {
            return std::ranges::equal(std::span{memory.bytes()}.subspan(sector.address - start, 4096),
                                      sector.bytes);
        });
    };
    NorFlash old_memory{3};
    BootRom old_rom{old_memory};
    flash(old_rom, old_image);
    REQUIRE(holds(old_memory, old_image));
    std::size_t broken_off = 0;
    for (std::size_t steps = 0;; ++steps) {
        CAPTURE(steps);
        NorFlash memory = old_memory;
        BootRom rom{memory};
        rom.unplugged_after = steps;
        try {
            flash(rom, new_image);
        } catch (const Failure& failure) {
            CHECK(failure.status() == ExitStatus::unplugged);
            ++broken_off;
        }
        CHECK((!begins(memory, old_image) || holds(memory, old_image)));
        CHECK((!begins(memory, new_image) || holds(memory, new_image)));
        if (rom.restart)
            break;
        BootRom again{memory};
        flash(again, new_image);
        CHECK(holds(memory, new_image));
    }
    CHECK(broken_off > 90);
}

}
