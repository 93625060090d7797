#include "tests/host/commands/flasher.hpp"

#include <doctest/doctest.h>

#include <csignal>

namespace kfast::test {

TEST_CASE("a new board gets firmware, settings and scene, and plays")
{
    Flasher flasher;
    DeskPico& pico = flasher.desk.add("1-2.3");
    const PlayerOutcome player = flasher.run_and_wait();
    const FlashOutcome& outcome = flasher.outcome;
    CHECK(has(outcome.contents, "firmware of 10240 bytes, settings of pico-st7789 with dc=8, scene of "));
    CHECK(outcome.port == "1-2.3");
    CHECK(outcome.addresses ==
          std::vector<std::uint32_t>{0x1000'0000, 0x1000'1000, 0x1000'2000, 0x1003'F000, 0x1004'0000});
    CHECK(outcome.differing == outcome.addresses);
    CHECK(outcome.written == 5);
    CHECK(outcome.verified);
    CHECK(outcome.restarted);
    CHECK(holds(pico, BusKind::spi));
    CHECK(settings_of(pico).pin(PinRole::dc) == 8);
    CHECK(pico.has_scene());
    CHECK(player.name == "E66058388341A22C");
    CHECK(player.playing.is_playing);
    CHECK(player.playing.home == link::Home::built_in);
    CHECK(!player.left_slot);
}

TEST_CASE("what a board holds already is not written again")
{
    Flasher flasher;
    DeskPico& pico = flasher.desk.add("1-2.3");
    flasher.run();
    pico.boot_loader.changed = false;
    flasher.run_and_wait();
    CHECK(flasher.outcome.differing->empty());
    CHECK(flasher.outcome.written == 0);
    CHECK(flasher.outcome.verified);
    CHECK(!pico.boot_loader.changed);

    flasher.wish.settings.pins = {"dc=9"};
    flasher.run();
    CHECK(settings_of(pico).pin(PinRole::dc) == 9);
    flasher.wish.settings.pins = {"dc=10"};
    flasher.run_and_wait();
    CHECK(flasher.outcome.differing == std::vector<std::uint32_t>{0x1003'F000});
    CHECK(flasher.outcome.written == 2); // the first sector is, always
}

TEST_CASE("a drive that goes away in the middle leaves a board that another run repairs")
{
    Flasher flasher;
    flasher.desk.add("1-2");
    flasher.desk.drives = {{"/media/RPI-RP2", "RPI-RP2"}};
    flasher.order.place.drive = "/media/RPI-RP2";
    flasher.desk.is_full = true;
    CHECK(has(flasher.refusal(), "5: the drive is gone\nThe board does not start what was not written"));
}

TEST_CASE("a board that is unplugged in the middle starts nothing, and another run repairs it")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2");
    flasher.wish.settings.pins = {"dc=9"};
    bool was_broken_off = false;
    for (std::size_t step = 8; !was_broken_off || pico.has_scene(); step += 7) {
        Flasher::prepare(pico, BusKind::i2c, "pico-ssd1306-i2c");
        std::ranges::fill(std::span{pico.flash.bytes()}.subspan(0x4'0000, 4096), std::byte{0xFF});
        pico.start();
        pico.boot_loader.unplugged_after = pico.boot_loader.steps + step;
        const std::string refusal = flasher.refusal();
        if (refusal == "nothing")
            break;
        CAPTURE(step);
        CHECK(refusal.starts_with("5: unplugged"));
        pico.boot_loader.unplugged_after = PretendBootLoader::never;
        if (!has(refusal, "the same command once more repairs it"))
            continue; // nothing was changed yet
        was_broken_off = true;
        pico.start(); // plugged in again
        CHECK(pico.state == State::in_boot_loader);
        flasher.run_and_wait();
        CHECK(flasher.outcome.verified);
        CHECK(holds(pico, BusKind::spi));
        CHECK(settings_of(pico).pin(PinRole::dc) == 9);
    }
    CHECK(was_broken_off);
}

TEST_CASE("what reads back differently is told with its address")
{
    Flasher flasher;
    DeskPico& pico = flasher.desk.add("1-2");
    pico.boot_loader.after_read = [&](std::uint32_t address, std::span<std::byte> bytes) {
        if (pico.boot_loader.changed && address == 0x1000'1000)
            bytes[7] ^= std::byte{1};
    };
    const std::string refusal = flasher.refusal();
    CHECK(has(refusal, "10: "));
    CHECK(has(refusal, "0x10001007"));
    CHECK(has(refusal, "the same command once more repairs it"));
    pico.start();
    CHECK(pico.state == State::in_boot_loader);
}

TEST_CASE("a board that runs is asked to enter its boot loader, and is awaited by its serial number")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2", "E7");
    DeskPico& other = flasher.desk.add("1-3", "E6");
    other.state = State::unplugged;
    flasher.order.place.serial = "E7";
    flasher.on_progress = [&](FlashPhase, std::size_t, std::size_t) { other.start(); };
    const PlayerOutcome player = flasher.run_and_wait();
    CHECK(flasher.outcome.port == "1-2");
    CHECK(flasher.outcome.serial == "E7");
    CHECK(pico.starts == 2);
    CHECK(pico.has_scene());
    CHECK(player.playing.is_playing);
    CHECK(!other.boot_loader.changed);
}

TEST_CASE("a board that was asked for nothing plays again")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2");
    flasher.wish.settings = {};
    flasher.wish.firmware = flasher.images.file(BusKind::i2c).string();
    CHECK(has(flasher.refusal(), "firmware for displays on i2c, but the display of the board is on spi"));
    CHECK(pico.starts == 2);
    CHECK(pico.state == State::running);
    CHECK(!pico.boot_loader.changed);
}

TEST_CASE("a boot loader or a player that does not come is not waited for for ever")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2");
    flasher.order.last_patience = Milliseconds{2500};
    SUBCASE("a boot loader")
    {
        pico.is_deaf = true;
        CHECK(has(flasher.refusal(),
                  "9: the board was asked to enter its boot loader, which has not been seen "
                  "for 2.5 seconds: unplug it, hold BOOTSEL"));
        CHECK(flasher.desk.now() < Milliseconds{3000});
    }
    SUBCASE("a player")
    {
        flasher.on_progress = [&](FlashPhase, std::size_t, std::size_t) { pico.serial = "another"; };
        CHECK(has(flasher.refusal(),
                  "9: the board was flashed and has restarted, but: no player has come for 2.5 seconds"));
    }
    SUBCASE("a player that may not be opened")
    {
        flasher.on_progress = [&](FlashPhase, std::size_t, std::size_t) {
            pico.forbidden = PretendFlashEnvironment::always;
        };
        CHECK(has(flasher.refusal(), "4: the board was flashed and has restarted, but: you may not"));
    }
}

TEST_CASE("a slot that would play gives way to the scene that was flashed")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2");
    pico.plays_slot = true;
    const auto scene = padded_scene(500, 1);
    REQUIRE(pico.player.upload(LinkBench::begin_for_slot(2, "eyes", scene), scene, 3).status == Status::ok);
    REQUIRE(pico.player.does(link::ChooseSlot{2}));
    const PlayerOutcome player = flasher.run_and_wait();
    CHECK(player.left_slot == 2);
    CHECK(!pico.player.ask<link::SlotContents>(link::AskSlot{2}).is_chosen);
    CHECK(player.playing.home == link::Home::built_in);
    CHECK(pico.player.device.selection.home == link::Home::built_in);

    flasher.wish.scene = "";
    const PlayerOutcome unchanged = flasher.run_and_wait();
    CHECK(!unchanged.left_slot);
    CHECK(unchanged.playing.home == link::Home::slot);
}

TEST_CASE("verifying alone writes nothing")
{
    Flasher flasher;
    DeskPico& pico = flasher.desk.add("1-2");
    flasher.run();
    pico.boot_loader.changed = false;
    flasher.order.purpose = FlashPurpose::verify_only;
    const FlashOutcome same = flasher.run(); // a board that runs: it is asked, and goes on
    CHECK(same.verified);
    CHECK(same.restarted);
    CHECK(pico.state == State::running);

    pico.state = State::in_boot_loader;
    CHECK(!flasher.run().restarted);
    CHECK(pico.state == State::in_boot_loader);

    pico.flash.bytes()[0x1'0002 - 0xF000] ^= std::byte{4};
    CHECK(has(flasher.refusal(), "10: flash is not what it should be at 0x10001002"));
    CHECK(!pico.boot_loader.changed);
}

TEST_CASE("settings that are lost while they are changed are told of")
{
    Flasher flasher;
    flasher.wish.settings = {.config = {}, .panel = {}, .pins = {"reset=13"}};
    flasher.wish.no_firmware = true;
    DeskPico& pico = flasher.running("1-2");
    pico.boot_loader.unplugged_after = pico.boot_loader.steps + 2 + 2 + 1; // found, compared, erased
    CHECK(has(flasher.refusal(),
              "the same command once more repairs it. If it says that no settings can be read, "
              "they are lost: name the display with --panel then"));
    pico.boot_loader.unplugged_after = PretendBootLoader::never;
    pico.state = State::in_boot_loader;
    CHECK(has(flasher.refusal(), "none can be read there"));
    flasher.wish.settings.panel = "st7789";
    CHECK(flasher.run_and_wait().playing.is_playing);
    CHECK(settings_of(pico).pin(PinRole::reset) == 13);
}

TEST_CASE("an interruption leaves a board that another run repairs")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2");
    {
        const RememberedInterruption interruption;
        flasher.on_progress = [](FlashPhase phase, std::size_t done, std::size_t) {
            if (phase == FlashPhase::writing && done == 2)
                std::raise(SIGINT);
        };
        CHECK(has(flasher.refusal(), "130: interrupted\nThe board does not start what was not written"));
    }
    pico.start();
    CHECK(pico.state == State::in_boot_loader);
    flasher.on_progress = [](FlashPhase, std::size_t, std::size_t) {};
    flasher.run_and_wait();
    CHECK(pico.has_scene());
}

TEST_CASE("an interruption before anything is written lets the board play again")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2");
    const RememberedInterruption interruption;
    flasher.on_progress = [](FlashPhase phase, std::size_t done, std::size_t) {
        if (phase == FlashPhase::comparing && done == 1)
            std::raise(SIGINT);
    };
    CHECK(flasher.refusal() == "130: interrupted");
    CHECK(!pico.boot_loader.changed);
    CHECK(pico.state == State::running);
}

}
