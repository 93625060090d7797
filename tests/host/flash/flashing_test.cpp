#include "host/flash/flashing.hpp"

#include "host/program/interruption.hpp"
#include "tests/host/flash/failure_of.hpp"
#include "tests/host/flash/pretend_boot_loader.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::uint32_t start = NorFlash::begin;

std::vector<std::byte> random_bytes(std::size_t count, unsigned seed)
{
    std::mt19937 random{seed};
    std::vector<std::byte> bytes(count);
    std::ranges::generate(bytes, [&random] { return static_cast<std::byte>(random()); });
    return bytes;
}

/// Firmware in three sectors, settings in the sixth, a scene in the seventh and eighth.
std::vector<FlashRegion> old_regions()
{
    return {{start, random_bytes(9000, 1)},
            {start + 0x5000, random_bytes(40, 2)},
            {start + 0x6000, random_bytes(5000, 3)}};
}

/// The same with another part of the firmware and another scene.
std::vector<FlashRegion> new_regions()
{
    auto regions = old_regions();
    regions[0].bytes[6000] ^= std::byte{1};
    regions[2].bytes = random_bytes(4500, 4);
    return regions;
}

void ignore(FlashPhase, std::size_t, std::size_t) {}

void flash(BootLoader& boot_loader, const FlashImage& image)
{
    write_sectors(boot_loader, image, differing_sectors(boot_loader, image, ignore), ignore);
}

NorFlash flash_with(const FlashImage& image)
{
    NorFlash memory{12};
    for (const auto& sector : image.sectors())
        std::ranges::copy(sector.bytes, memory.bytes().begin() + (sector.address - start));
    return memory;
}

/// A board starts when its first page is whole; the others are what it then runs.
bool starts(const NorFlash& memory, const FlashImage& image)
{
    return std::ranges::equal(std::span{memory.bytes()}.first(256),
                              std::span{image.sectors()[0].bytes}.first(256));
}

bool holds(const NorFlash& memory, const FlashImage& image)
{
    return memory.bytes() == flash_with(image).bytes();
}

}

TEST_CASE("the sectors that differ are found, and nothing else is")
{
    const FlashImage old_image{old_regions()};
    const FlashImage new_image{new_regions()};
    NorFlash memory = flash_with(old_image);
    PretendBootLoader boot_loader{memory};
    CHECK(differing_sectors(boot_loader, old_image, ignore).empty());
    CHECK(differing_sectors(boot_loader, new_image, ignore) == std::vector<std::size_t>{1, 4, 5});
    CHECK_FALSE(boot_loader.changed);
}

TEST_CASE("only sectors that differ are written, and the first one")
{
    const FlashImage new_image{new_regions()};
    NorFlash memory = flash_with(FlashImage{old_regions()});
    PretendBootLoader boot_loader{memory};
    flash(boot_loader, new_image);
    CHECK(holds(memory, new_image));
    const std::size_t compared = 6;
    const std::size_t written = 4 * (1 + 16);
    const std::size_t verified = 4 + 1;
    CHECK(boot_loader.steps == compared + written + verified);
}

TEST_CASE("an image that is there already is not written")
{
    const FlashImage image{old_regions()};
    NorFlash memory = flash_with(image);
    PretendBootLoader boot_loader{memory};
    flash(boot_loader, image);
    CHECK_FALSE(boot_loader.changed);
    CHECK(boot_loader.steps == image.sectors().size());
    flash(boot_loader, FlashImage{std::span<const FlashRegion>{}});
    CHECK_FALSE(boot_loader.changed);
}

TEST_CASE(
    "a board that was unplugged after any step starts nothing or what it had, and a second run repairs it")
{
    const FlashImage old_image{old_regions()};
    const FlashImage new_image{new_regions()};
    std::size_t broken_off = 0;
    for (std::size_t steps = 0;; ++steps) {
        CAPTURE(steps);
        NorFlash memory = flash_with(old_image);
        PretendBootLoader boot_loader{memory};
        boot_loader.unplugged_after = steps;
        try {
            flash(boot_loader, new_image);
            break;
        } catch (const Failure& failure) {
            CHECK(failure.status() == ExitStatus::unplugged);
        }
        ++broken_off;
        if (starts(memory, old_image))
            CHECK((holds(memory, old_image) || holds(memory, new_image)));
        boot_loader.unplugged_after = PretendBootLoader::never;
        flash(boot_loader, new_image);
        CHECK(holds(memory, new_image));
    }
    CHECK(broken_off == 6 + 4 * 17 + 5);
}

TEST_CASE("a run after one with another image repairs as well")
{
    const FlashImage old_image{old_regions()};
    for (std::size_t steps = 0; steps < 70; steps += 7) {
        NorFlash memory = flash_with(old_image);
        PretendBootLoader boot_loader{memory};
        boot_loader.unplugged_after = steps;
        CHECK_THROWS_AS(flash(boot_loader, FlashImage{new_regions()}), Failure);
        boot_loader.unplugged_after = PretendBootLoader::never;
        flash(boot_loader, old_image);
        CHECK(holds(memory, old_image));
    }
}

TEST_CASE("what reads back differently is told with its address")
{
    const FlashImage image{old_regions()};
    NorFlash memory{12};
    PretendBootLoader boot_loader{memory};
    const std::uint32_t spoiled = start + 0x6123;
    const std::byte right = old_regions()[2].bytes[0x123];
    boot_loader.after_read = [&](std::uint32_t address, std::span<std::byte> bytes) {
        if (address <= spoiled && spoiled - address < bytes.size())
            bytes[spoiled - address] = ~right;
    };
    const std::string text = failure_of([&] { flash(boot_loader, image); }, ExitStatus::not_verified);
    CHECK(text.starts_with("flash is not what it should be at 0x10006123: expected 0x"));
    CHECK(text.find("flash it again") != std::string::npos);
    CHECK_FALSE(starts(memory, image));
}

TEST_CASE("a board whose first sector reads back differently starts nothing")
{
    const FlashImage image{old_regions()};
    NorFlash memory{12};
    PretendBootLoader boot_loader{memory};
    boot_loader.after_read = [&](std::uint32_t address, std::span<std::byte> bytes) {
        if (address == start && starts(memory, image))
            bytes[300] ^= std::byte{0x80};
    };
    failure_of([&] { flash(boot_loader, image); }, ExitStatus::not_verified);
    CHECK_FALSE(starts(memory, image));
}

TEST_CASE("a flash in which two sectors of the image are one is found out")
{
    const FlashImage image{std::array{FlashRegion{start, random_bytes(8192, 1)},
                                      FlashRegion{start + 0x4000, random_bytes(4096, 2)}}};
    class Aliased final : public BootLoader {
    public:
        explicit Aliased(PretendBootLoader& inner) : inner_{inner} {}
        void read(std::uint32_t address, std::span<std::byte> bytes) override
        {
            inner_.read(address & ~0x4000U, bytes);
        }
        void erase(std::uint32_t address, std::size_t bytes) override
        {
            inner_.erase(address & ~0x4000U, bytes);
        }
        void write(std::uint32_t address, std::span<const std::byte> bytes) override
        {
            inner_.write(address & ~0x4000U, bytes);
        }
        void restart() override {}

    private:
        PretendBootLoader& inner_;
    };
    NorFlash memory{4};
    PretendBootLoader inner{memory};
    Aliased boot_loader{inner};
    CHECK(failure_of([&] { flash(boot_loader, image); }, ExitStatus::not_verified)
              .find("at 0x10000000: expected 0xff") != std::string::npos);
    CHECK_FALSE(starts(memory, image));
}

TEST_CASE("verification tells where flash holds something else, and changes nothing")
{
    const FlashImage image{old_regions()};
    NorFlash memory = flash_with(image);
    memory.bytes()[0x5000] = std::byte{0x12};
    const std::byte right = old_regions()[1].bytes[0];
    PretendBootLoader boot_loader{memory};
    std::array<char, 100> text{};
    std::snprintf(text.data(), text.size(), "at 0x10005000: expected 0x%02x, found 0x12: the board holds",
                  std::to_integer<unsigned>(right));
    CHECK(
        failure_of([&] { verify(boot_loader, image, ignore); }, ExitStatus::not_verified).find(text.data()) !=
        std::string::npos);
    CHECK_FALSE(boot_loader.changed);
    memory.bytes()[0x5000] = right;
    verify(boot_loader, image, ignore);
}

TEST_CASE("progress goes through each phase from nothing to all")
{
    const FlashImage image{old_regions()};
    NorFlash memory{12};
    PretendBootLoader boot_loader{memory};
    std::vector<std::pair<FlashPhase, std::size_t>> progress;
    const auto on_progress = [&progress](FlashPhase phase, std::size_t done, std::size_t total) {
        CHECK(total == 6);
        progress.emplace_back(phase, done);
    };
    write_sectors(boot_loader, image, differing_sectors(boot_loader, image, on_progress), on_progress);
    std::vector<std::pair<FlashPhase, std::size_t>> expected;
    for (const FlashPhase phase : {FlashPhase::comparing, FlashPhase::writing, FlashPhase::verifying})
        for (std::size_t done = 0; done <= 6; ++done)
            expected.emplace_back(phase, done);
    CHECK(progress == expected);
}

TEST_CASE("an interruption stops between two sectors, and the board starts nothing")
{
    const FlashImage old_image{old_regions()};
    const FlashImage new_image{new_regions()};
    for (const FlashPhase in : {FlashPhase::comparing, FlashPhase::writing, FlashPhase::verifying}) {
        NorFlash memory = flash_with(old_image);
        PretendBootLoader boot_loader{memory};
        const RememberedInterruption interruption;
        const auto on_progress = [in](FlashPhase phase, std::size_t done, std::size_t) {
            if (phase == in && done == 2)
                std::raise(SIGINT);
        };
        const auto run = [&] {
            write_sectors(boot_loader, new_image, differing_sectors(boot_loader, new_image, on_progress),
                          on_progress);
        };
        CHECK_THROWS_AS(run(), Interrupted);
        CHECK(boot_loader.changed == (in != FlashPhase::comparing));
        CHECK(starts(memory, old_image) == (in == FlashPhase::comparing));
    }
}

}
