#include "firmware/board_record.hpp"
#include "host/commands/flash_job.hpp"
#include "host/config/config_input.hpp"
#include "tests/host/commands/pretend_images.hpp"
#include "tests/host/commands/pretend_workbench.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <iostream>
#include <sstream>

namespace kfast::test {
namespace {

using State = DeskPico::State;

constexpr const char* small_scene = "kfast 1\ncanvas 60 40 frames=10\nobject dot fill=white { key 0 { rect 1 "
                                    "1 9 9 }; key 5 { rect 20 1 9 9 } }\n";
/// Its outlines find no room in a Pico.
const std::string large_scene = [] {
    std::string circles;
    for (int place = 0; place < 3600; ++place)
        circles +=
            " circle " + std::to_string(4 * (place % 60)) + ' ' + std::to_string(4 * (place / 60)) + " r=2;";
    return "kfast 1\ncanvas 240 240 frames=2\nobject dots fill=red {" + circles + " }\n";
}();

/// What is printed to standard error while it lives.
class Heard {
public:
    Heard() : before_{std::cerr.rdbuf(text_.rdbuf())} {}
    ~Heard() { std::cerr.rdbuf(before_); }
    Heard(const Heard&) = delete;
    Heard& operator=(const Heard&) = delete;

    std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
    std::streambuf* before_;
};

/// Someone who flashes boards on a desk: a scene onto an ST7789 with other pins, unless something else is
/// said.
struct Flasher {
    FlashOutcome run()
    {
        const FlashPlan plan{wish, images.folders()};
        return FlashJob{desk, plan, order, tell}.run();
    }
    PlayerOutcome run_and_wait()
    {
        const FlashPlan plan{wish, images.folders()};
        FlashJob job{desk, plan, order, tell};
        outcome = job.run();
        return job.await_player();
    }
    /// As it says; "status: text".
    std::string refusal()
    {
        try {
            run_and_wait();
        } catch (const Failure& failure) {
            return std::to_string(static_cast<int>(failure.status())) + ": " + failure.what();
        }
        return "nothing";
    }
    /// Of what can be said of a Pico that was there before: its settings and firmware.
    static void prepare(DeskPico& pico, BusKind bus, const std::string& configuration)
    {
        std::ranges::copy(pretend_image(bus), pico.flash.bytes().begin());
        const auto sector = config::settings_sector(config::chosen_settings(configuration));
        std::ranges::copy(sector, pico.flash.bytes().begin() + 0x3'F000);
    }
    DeskPico& running(const std::string& port, const std::string& serial = "E66058388341A22C")
    {
        DeskPico& pico = desk.add(port, serial);
        prepare(pico, BusKind::spi, "pico-st7789");
        pico.start();
        return pico;
    }

    PretendImages images;
    PretendWorkbench desk;
    PlanWish wish{.scene = images.text("scene.kfast", small_scene),
                  .firmware = {},
                  .settings = {.config = {}, .panel = "st7789", .pins = {"dc=8"}}};
    FlashOrder order;
    FlashOutcome outcome;
    TellFlashing tell = [](FlashPhase, std::size_t, std::size_t) {};
};

BoardSettings settings_of(const DeskPico& pico)
{
    return read_board_record(std::span{pico.flash.bytes()}.subspan(0x3'F000)).value();
}

bool holds(const DeskPico& pico, BusKind bus)
{
    const auto image = pretend_image(bus);
    return std::equal(image.begin(), image.end(), pico.flash.bytes().begin());
}

bool has(const std::string& text, const std::string& part)
{
    CAPTURE(text);
    return text.find(part) != text.npos;
}

}

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

TEST_CASE("without a board it is told how one is found")
{
    Flasher flasher;
    CHECK(has(flasher.refusal(), "3: there is no board: hold BOOTSEL while you plug the Pico in"));
    flasher.order.place.port = "1-2";
    CHECK(has(flasher.refusal(), "3: there is no board in its boot loader at \"1-2\": hold BOOTSEL"));
    flasher.desk.add("1-3");
    CHECK(has(flasher.refusal(), "at \"1-2\": there are: 1-3"));
    flasher.order.place = {.port = {}, .serial = "E6", .drive = {}};
    CHECK(has(flasher.refusal(), "3: no board that runs KFAST has the serial number \"E6\": none is there"));
    flasher.running("1-4", "E7");
    CHECK(has(flasher.refusal(), "\"E6\": there are: E7"));
}

TEST_CASE("of several boards one must be chosen")
{
    Flasher flasher;
    DeskPico& first = flasher.desk.add("1-2");
    DeskPico& second = flasher.desk.add("1-3");
    CHECK(
        has(flasher.refusal(), "2: several boards are in their boot loaders: choose with --port: 1-2, 1-3"));
    flasher.order.place.port = "1-3";
    CHECK(flasher.run().port == "1-3");
    CHECK(!first.boot_loader.changed);
    CHECK(second.boot_loader.changed);
}

TEST_CASE("of several boards that run one must be chosen, unless one is in its boot loader")
{
    Flasher flasher;
    DeskPico& first = flasher.running("1-2", "E6");
    DeskPico& second = flasher.running("1-3", "E7");
    CHECK(has(flasher.refusal(), "2: several boards run KFAST: choose with --serial: E6, E7"));
    flasher.order.place.serial = "E7";
    CHECK(flasher.run().port == "1-3");
    CHECK(second.boot_loader.changed);
    flasher.desk.add("1-4");
    flasher.order.place.serial = "";
    CHECK(flasher.run().port == "1-4");
    CHECK(!first.boot_loader.changed);
}

TEST_CASE("of several drives one must be chosen")
{
    Flasher flasher;
    flasher.desk.drives = {{"/media/a", "RPI-RP2"}, {"/media/b", "RPI-RP2"}};
    CHECK(has(flasher.refusal(),
              "2: several boards are mounted as drives: choose with --drive: /media/a, /media/b"));
}

TEST_CASE("another chip is refused, and passed over where there is a right one")
{
    Flasher flasher;
    DeskPico& other = flasher.desk.add("1-2");
    other.chip = BootChip::rp2350;
    CHECK(has(flasher.refusal(), "11: the board at 1-2 has an RP2350"));
    flasher.order.place.port = "1-2";
    CHECK(has(flasher.refusal(), "11: the board at 1-2 has an RP2350"));
    flasher.order.place.port = "";
    flasher.desk.add("1-3");
    CHECK(flasher.run().port == "1-3");
    CHECK(!other.boot_loader.changed);
}

TEST_CASE("a board that may not be opened is written to through its drive, if there is one")
{
    Flasher flasher;
    const Heard heard;
    DeskPico& pico = flasher.desk.add("1-2");
    pico.forbidden = 1;
    CHECK(flasher.refusal() == "4: you may not");
    flasher.desk.drives = {{"/media/RPI-RP2", "RPI-RP2"}};
    pico.forbidden = 1;
    flasher.run_and_wait();
    CHECK(has(heard.text(), "kfast: warning: you may not\nThe drive of the board is used instead."));
    CHECK(flasher.outcome.drive == "/media/RPI-RP2");
    CHECK(flasher.outcome.port.empty());
    CHECK(!flasher.outcome.differing);
    CHECK(flasher.outcome.written == 5);
    CHECK(!flasher.outcome.verified);
    CHECK(holds(pico, BusKind::spi));
}

TEST_CASE("a board whose boot loader is a drive alone is written to through that")
{
    Flasher flasher;
    const Heard heard;
    DeskPico& pico = flasher.desk.add("1-2");
    pico.has_picoboot = false;
    CHECK(has(flasher.refusal(), "8: the boot loader was started without PICOBOOT: plug the board in anew"));
    flasher.desk.drives = {{"/media/RPI-RP2", "RPI-RP2"}};
    CHECK(flasher.run_and_wait().playing.is_playing);
    CHECK(has(heard.text(),
              "without PICOBOOT: plug the board in anew with BOOTSEL held down\nThe drive of the "
              "board is used instead."));
    CHECK(flasher.outcome.drive == "/media/RPI-RP2");
    CHECK(holds(pico, BusKind::spi));
}

TEST_CASE("the drive is not used for what it cannot do")
{
    Flasher flasher;
    flasher.desk.drives = {{"/media/RPI-RP2", "RPI-RP2"}};
    DeskPico& pico = flasher.desk.add("1-2");
    SUBCASE("to verify")
    {
        flasher.order.purpose = FlashPurpose::verify_only;
        pico.forbidden = 1;
        CHECK(flasher.refusal() == "4: you may not");
        flasher.order.place.drive = "/media/RPI-RP2";
        CHECK(has(flasher.refusal(), "2: a drive does not tell what lies in flash"));
    }
    SUBCASE("to tell which firmware it needs")
    {
        flasher.wish.settings = {};
        pico.forbidden = 1;
        CHECK(flasher.refusal() ==
              "4: you may not\nIts drive at /media/RPI-RP2 does not tell which display it "
              "has: with --panel or --config, the drive is used instead");
    }
    SUBCASE("when another program has the board")
    {
        pico.unready = 1;
        CHECK(flasher.refusal() == "8: USB fails");
    }
    SUBCASE("when it may be that of another board")
    {
        flasher.desk.add("1-3");
        flasher.order.place.port = "1-2";
        pico.forbidden = 1;
        CHECK(flasher.refusal() == "4: you may not");
    }
    CHECK(!pico.boot_loader.changed);
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
    flasher.tell = [&](FlashPhase, std::size_t, std::size_t) { other.start(); };
    const PlayerOutcome player = flasher.run_and_wait();
    CHECK(flasher.outcome.port == "1-2");
    CHECK(flasher.outcome.serial == "E7");
    CHECK(pico.starts == 2);
    CHECK(pico.has_scene());
    CHECK(player.playing.is_playing);
    CHECK(!other.boot_loader.changed);
}

TEST_CASE("a boot loader that has just come is waited for until it can be used")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2");
    flasher.desk.on_boards = [&] {
        if (pico.state == State::running && pico.player.device.is_in_boot_loader) {
            pico.forbidden = 5; // until udev has set its permissions
            pico.unready = 5;   // until Linux has configured it
        }
    };
    flasher.run_and_wait();
    CHECK(pico.has_scene());
    CHECK(pico.forbidden == 0);
    CHECK(pico.unready == 0);

    // One that was there before is not.
    pico.state = State::in_boot_loader;
    pico.forbidden = 1;
    CHECK(flasher.refusal() == "4: you may not");
}

TEST_CASE("a player that cannot be asked may be left by hand")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2");
    pico.forbidden = 1;
    CHECK(flasher.refusal() ==
          "4: you may not\nOr let it enter its boot loader by hand: hold BOOTSEL while you "
          "plug the Pico in, and ask again");
    CHECK(pico.starts == 1);
}

TEST_CASE("nothing is asked of a board before all is checked")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2");
    SUBCASE("a scene that does not fit the settings")
    {
        flasher.wish.scene = flasher.images.text("large.kfast", large_scene);
        CHECK(has(flasher.refusal(), "7: " + flasher.wish.scene + ": does not fit pico\n  "));
    }
    SUBCASE("a scene that does not fit the display that the board tells of")
    {
        flasher.wish.scene = flasher.images.text("large.kfast", large_scene);
        flasher.wish.settings = {};
        const std::string refusal = flasher.refusal();
        CHECK(has(refusal, "7: " + flasher.wish.scene + ": does not fit pico\n  "));
        CHECK(!has(refusal, "by hand"));
    }
    SUBCASE("an image that is missing")
    {
        flasher.wish.settings = {};
        std::filesystem::remove(flasher.images.file(BusKind::parallel_8));
        CHECK(has(flasher.refusal(), "1: there is no pico-parallel.bin in "));
    }
    CHECK(pico.starts == 1);
    CHECK(pico.state == State::running);
    CHECK(!pico.player.device.is_in_boot_loader);
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
        flasher.tell = [&](FlashPhase, std::size_t, std::size_t) { pico.serial = "another"; };
        CHECK(has(flasher.refusal(),
                  "9: the board was flashed and has restarted, but: no player has come for 2.5 seconds"));
    }
    SUBCASE("a player that may not be opened")
    {
        flasher.tell = [&](FlashPhase, std::size_t, std::size_t) {
            pico.forbidden = PretendWorkbench::always;
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
    CHECK(pico.player.device.programme.home == link::Home::built_in);

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

TEST_CASE("a boot loader that restarts is not there any more for who looks next")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2");
    SUBCASE("after a comparison")
    {
        flasher.run();
        flasher.order.purpose = FlashPurpose::verify_only;
    }
    SUBCASE("after writing") {}
    pico.lingers = 4;
    const int starts = pico.starts;
    flasher.run();
    CHECK(pico.state == State::running);
    CHECK(pico.starts == starts + 1);
}

TEST_CASE("a dry run tells what would be written, and touches nothing")
{
    Flasher flasher;
    flasher.order.purpose = FlashPurpose::dry_run;
    SUBCASE("without a board")
    {
        const FlashOutcome outcome = flasher.run();
        CHECK(outcome.addresses.size() == 5);
        CHECK(!outcome.differing);
        CHECK(outcome.port.empty());
    }
    SUBCASE("a board that runs is not asked")
    {
        DeskPico& pico = flasher.running("1-2");
        CHECK(!flasher.run().differing);
        CHECK(pico.starts == 1);
        CHECK(!pico.player.device.is_in_boot_loader);
    }
    SUBCASE("a board in its boot loader is read")
    {
        DeskPico& pico = flasher.desk.add("1-2");
        Flasher::prepare(pico, BusKind::spi, "pico-st7789");
        const FlashOutcome outcome = flasher.run();
        CHECK(outcome.differing == std::vector<std::uint32_t>{0x1003'F000, 0x1004'0000});
        CHECK(outcome.written == 0);
        CHECK(!outcome.restarted);
        CHECK(!outcome.verified);
        CHECK(!pico.boot_loader.changed);
        CHECK(pico.state == State::in_boot_loader);
    }
    SUBCASE("a drive")
    {
        flasher.desk.add("1-2").state = State::unplugged;
        flasher.desk.drives = {{"/media/RPI-RP2", "RPI-RP2"}};
        const FlashOutcome outcome = flasher.run();
        CHECK(outcome.drive == "/media/RPI-RP2");
        CHECK(outcome.written == 0);
        CHECK(!outcome.restarted);
    }
    SUBCASE("no line is pulled")
    {
        flasher.order.lines = BootLines{{}, "GPIO17", "GPIO27"};
        CHECK(!flasher.run().differing);
        CHECK(flasher.desk.pulled.empty());
    }
}

TEST_CASE("the settings of the board decide the firmware if none are told")
{
    Flasher flasher;
    flasher.wish.settings = {};
    DeskPico& pico = flasher.desk.add("1-2");
    SUBCASE("there are some")
    {
        Flasher::prepare(pico, BusKind::i2c, "pico-ssd1306-i2c");
        const Heard heard;
        pico.flash.bytes()[0x1000] ^= std::byte{1};
        CHECK(flasher.run().addresses.size() == 4);
        CHECK(holds(pico, BusKind::i2c));
        CHECK(heard.text().empty());
    }
    SUBCASE("there are none")
    {
        const Heard heard;
        flasher.run();
        CHECK(holds(pico, BusKind::spi));
        CHECK(has(heard.text(),
                  "the board does not know its display, so the firmware is that for pico-st7789"));
    }
    SUBCASE("there are some that a Pico cannot follow")
    {
        const Heard heard;
        Flasher::prepare(pico, BusKind::i2c, "pico-ssd1306-i2c");
        BoardSettings wrong = config::chosen_settings("pico-ssd1306-i2c");
        wrong.panel.glass = {0, 0};
        std::ranges::copy(config::settings_sector(wrong), pico.flash.bytes().begin() + 0x3'F000);
        flasher.run();
        CHECK(holds(pico, BusKind::spi));
    }
    SUBCASE("a drive does not tell them")
    {
        const Heard heard;
        flasher.desk.drives = {{"/media/RPI-RP2", "RPI-RP2"}};
        flasher.order.place.drive = "/media/RPI-RP2";
        flasher.run();
        CHECK(holds(pico, BusKind::spi));
        CHECK(has(heard.text(),
                  "which display the board has is not known, so the firmware is that for pico-st7789"));
    }
}

TEST_CASE("pins alone change the settings of the board")
{
    Flasher flasher;
    flasher.wish.settings = {.config = {}, .panel = {}, .pins = {"reset=13", "backlight=none"}};
    DeskPico& pico = flasher.desk.add("1-2");
    CHECK(has(flasher.refusal(),
              "2: --pin alone changes the settings that the board has, and none can be read there"));
    CHECK(!pico.boot_loader.changed);
    Flasher::prepare(pico, BusKind::parallel_8, "pico-ili9341-parallel");
    CHECK(has(flasher.run().contents, "settings of the board with reset=13 backlight=none"));
    BoardSettings expected = config::chosen_settings("pico-ili9341-parallel");
    expected.pin(PinRole::reset) = 13;
    expected.pin(PinRole::backlight) = no_pin;
    CHECK(settings_of(pico) == expected);
    CHECK(holds(pico, BusKind::parallel_8));
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

TEST_CASE("firmware that is left alone must be there, and be right")
{
    Flasher flasher;
    flasher.wish.no_firmware = true;
    DeskPico& pico = flasher.desk.add("1-2");
    CHECK(has(flasher.refusal(), "1: there is no firmware on the board: leave out --no-firmware"));
    Flasher::prepare(pico, BusKind::i2c, "pico-ssd1306-i2c");
    CHECK(has(flasher.refusal(), "1: the firmware on the board is for displays on i2c, but the display of "
                                 "pico-st7789 with dc=8 is on spi"));
    CHECK(!pico.boot_loader.changed);
    Flasher::prepare(pico, BusKind::spi, "pico-st7789");
    flasher.run_and_wait();
    CHECK(flasher.outcome.addresses == std::vector<std::uint32_t>{0x1003'F000, 0x1004'0000});
}

TEST_CASE("a board enters its boot loader by lines")
{
    Flasher flasher;
    DeskPico& pico = flasher.desk.add("1-2");
    pico.state = State::unplugged;
    flasher.running("1-3", "E7"); // have nothing to do with it
    flasher.running("1-4", "E8");
    flasher.order.lines = BootLines{{}, "GPIO17", "GPIO27"};
    SUBCASE("it comes after a while")
    {
        flasher.desk.on_lines = [&] {
            flasher.desk.on_wait = [&] {
                if (flasher.desk.now() > Milliseconds{2000} && pico.starts == 0)
                    pico.state = State::in_boot_loader;
            };
        };
        CHECK(flasher.run().port == "1-2");
        CHECK(flasher.desk.pulled == "GPIO17 GPIO27");
        CHECK(pico.has_scene());
    }
    SUBCASE("it does not come")
    {
        CHECK(has(flasher.refusal(),
                  "9: no boot loader has been seen for 10 seconds after reset and boot line: "
                  "is GPIO17 wired to RUN, GPIO27 through a resistor"));
    }
    CHECK(!flasher.desk.picos.back().boot_loader.changed);
}

TEST_CASE("an interruption leaves a board that another run repairs")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2");
    {
        const RememberedInterruption interruption;
        flasher.tell = [](FlashPhase phase, std::size_t done, std::size_t) {
            if (phase == FlashPhase::writing && done == 2)
                std::raise(SIGINT);
        };
        CHECK(has(flasher.refusal(), "130: interrupted\nThe board does not start what was not written"));
    }
    pico.start();
    CHECK(pico.state == State::in_boot_loader);
    flasher.tell = [](FlashPhase, std::size_t, std::size_t) {};
    flasher.run_and_wait();
    CHECK(pico.has_scene());
}

TEST_CASE("an interruption before anything is written lets the board play again")
{
    Flasher flasher;
    DeskPico& pico = flasher.running("1-2");
    const RememberedInterruption interruption;
    flasher.tell = [](FlashPhase phase, std::size_t done, std::size_t) {
        if (phase == FlashPhase::comparing && done == 1)
            std::raise(SIGINT);
    };
    CHECK(flasher.refusal() == "130: interrupted");
    CHECK(!pico.boot_loader.changed);
    CHECK(pico.state == State::running);
}

}
