#include "tests/host/commands/flasher.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

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

}
