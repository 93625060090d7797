#include "tests/host/commands/flasher.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

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
    CHECK(has(flasher.refusal(), "2: several boards run KFAST: choose with --device: E6, E7"));
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

}
