#include "host/fit/board_reader.hpp"

#include "host/fit/board_texts.hpp"

#include <doctest/doctest.h>
#include <string>
#include <string_view>

namespace kfast::fit {
namespace {

const std::string whole = R"(board "my board" {
    core cortex-m4 clock=(MHz)80 cycles=1.25
    memory flash=(KiB)512 ram=(B)65536
    bus parallel-8 clock=(kHz)15000
    panel 320 172 format=grey4 window=9
    bands (KiB)8
    reserved flash=(KiB)40 ram=(KiB)3
}
)";

std::string with(std::string_view part, std::string_view other)
{
    std::string text = whole;
    return text.replace(text.find(part), part.size(), other);
}

Target read(const std::string& text)
{
    Diagnostics diagnostics;
    const SourceText source{"my.kdl", text};
    const auto target = read_board(source, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.sorted())
        MESSAGE(format(diagnostic, source));
    REQUIRE(target);
    return *target;
}

/// All that is said about a text that is wrong.
std::string complaints(const std::string& text)
{
    Diagnostics diagnostics;
    const SourceText source{"my.kdl", text};
    CHECK_FALSE(read_board(source, diagnostics));
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics.sorted())
        all += format(diagnostic, source);
    return all;
}

void check_refused(const std::string& text, std::string_view place, std::string_view says)
{
    const std::string said = complaints(text);
    CAPTURE(said);
    CHECK(said.find("my.kdl:" + std::string{place} + ": error:") != std::string::npos);
    CHECK(said.find(says) != std::string::npos);
}

}

TEST_CASE("a description tells everything in bytes, Hertz and pixels")
{
    const Target target = read(whole);
    CHECK(target.name == "my board");
    CHECK(target.processor == Processor::cortex_m4);
    CHECK(target.processor_name == "cortex-m4");
    CHECK(target.clock == 80e6);
    CHECK(target.cycles == 1.25);
    CHECK(target.flash == 512 * 1024);
    CHECK(target.ram == 65536);
    CHECK(target.bus.kind == BusKind::parallel_8);
    CHECK(target.bus.clock == 15e6);
    CHECK(target.display.size == Size{320, 172});
    CHECK(target.display.format == PixelFormat::grey4);
    CHECK(target.display.granularity == Size{2, 1});
    CHECK(target.display.window_bytes == 9);
    CHECK(target.band_bytes == 8192);
    CHECK(target.reserved_flash() == 40 * 1024);
    CHECK(target.reserved_ram() == 3 * 1024);
}

TEST_CASE("a board has what the scene needs of the player, or all of it")
{
    CHECK_FALSE(read(whole).has_every_feature);
    CHECK_FALSE(read(with("bands", "features needed; bands")).has_every_feature);
    CHECK(read(with("bands", "features all; bands")).has_every_feature);
    CHECK(read(whole).watchdog == 0);
    CHECK(read(with("bands", "watchdog (s)8.3; bands")).watchdog == 8.3);
    CHECK(read(with("bands", "watchdog (ms)250; bands")).watchdog == 0.25);
    check_refused(with("bands", "watchdog 8; bands"), "6:14", "(s)8");
    check_refused(with("bands", "watchdog; bands"), "6:5", "watchdog (s)8.3");
    check_refused(with("bands", "features some; bands"), "6:14", "some");
    check_refused(with("bands", "features; bands"), "6:5", "features all");
}

TEST_CASE("what is reserved has several parts, with names")
{
    const Target target =
        read(with("reserved flash", "reserved \"radio and slots\" flash=(KiB)5; reserved flash"));
    REQUIRE(target.reserved.size() == 2);
    CHECK(target.reserved[0].name == "radio and slots");
    CHECK(target.reserved[0].ram == 0);
    CHECK(target.reserved[1].name.empty());
    CHECK(target.reserved_flash() == 45 * 1024);
    CHECK(target.reserved_ram() == 3 * 1024);
}

TEST_CASE("a board has a beam in place of a panel")
{
    const Target target = read(R"(board a {
        core cortex-m0+ clock=(MHz)125
        memory flash=(MiB)2 ram=(KiB)264
        bus dac clock=(MHz)20
        beam galvo rate=(kHz)25
    })");
    REQUIRE(target.beam);
    CHECK(target.beam->rate == 25'000);
    CHECK(target.beam->is_laser);
    CHECK(target.bus.kind == BusKind::dac);
    const std::string begin = "board a { core cortex-m0 clock=(MHz)9; memory flash=(KiB)9 ram=(KiB)9; ";
    check_refused(begin + "bus dac clock=(MHz)9; beam scope; panel st7789 }", "1:1",
                  "both a panel and a beam");
    check_refused(begin + "bus spi clock=(MHz)9; beam scope }", "1:1", "a beam needs the bus of a converter");
    check_refused(begin + "bus dac clock=(MHz)9; panel st7789 }", "1:1", "this bus has no panel");
    check_refused(begin + "bus dac clock=(MHz)9; beam blue }", "1:99", "allowed: scope");
}

TEST_CASE("a panel can be named, with another size too")
{
    CHECK(read(with("320 172 format=grey4 window=9", "ssd1322")).display.size == Size{256, 64});
    CHECK(read(with("320 172 format=grey4 window=9", "st7789")).display.rated_spi == 62.5e6);
    const Display turned = read(with("320 172 format=grey4 window=9", "ili9341 320 240")).display;
    CHECK(turned.size == Size{320, 240});
    CHECK(turned.name == "ili9341");
}

TEST_CASE("a panel with another format is still written in its own steps")
{
    const auto steps = [](std::string_view panel) {
        return read(with("320 172 format=grey4 window=9", panel)).display.granularity;
    };
    CHECK(steps("ssd1306") == Size{8, 8});
    CHECK(steps("ssd1306 format=mono1_dithered") == Size{8, 8});
    CHECK(steps("ssd1306 format=grey4") == Size{8, 8});
    CHECK(steps("ssd1322 format=mono1") == Size{8, 1});
    CHECK(steps("ssd1322 format=rgb565") == Size{4, 1});
    CHECK(steps("st7789 format=rgb444") == Size{2, 1});
    CHECK(steps("320 172 format=grey4") == Size{2, 1});
    check_refused(with("320 172 format=grey4 window=9", "ssd1306 128 36 format=mono1_dithered"), "5:5",
                  "multiples of that");
}

TEST_CASE("what may be left out has a default, and M0+ is M0")
{
    const Target target = read(R"(board a {
        core cortex-m0+ clock=(MHz)48
        memory flash=(KiB)64 ram=(KiB)8
        bus i2c clock=(kHz)400
        panel ssd1306
    })");
    CHECK(target.processor == Processor::cortex_m0);
    CHECK(target.cycles == 0);
    CHECK(target.band_bytes == 4096);
    CHECK(target.reserved_flash() == 0);
    CHECK(target.reserved_ram() == 0);
}

TEST_CASE("a bus carries as many bytes as its kind and clock allow")
{
    CHECK(Bus{BusKind::spi, 8e6}.bytes_per_second() == 1e6);
    CHECK(Bus{BusKind::i2c, 900e3}.bytes_per_second() == 100e3);
    CHECK(Bus{BusKind::parallel_8, 10e6}.bytes_per_second() == 10e6);
    CHECK(Bus{BusKind::parallel_16, 10e6}.bytes_per_second() == 20e6);
}

TEST_CASE("the boards of this program are described without a mistake")
{
    CHECK(board_texts().size() >= 4);
    for (const BoardText& board : board_texts())
        CHECK(read(std::string{board.text}).name == board.name);
}

TEST_CASE("mistakes are told with their place and the remedy")
{
    check_refused(with("cortex-m4", "cortex-m5"), "2:10", "did you mean \"cortex-m");
    check_refused(with("cortex-m4", "cortex-m85"), "2:10", "is not measured: take cortex-m33");
    check_refused(with("320 172 format=grey4 window=9", "sh1106"), "5:11", "take one with an SSD1306");
    check_refused(with("clock=(MHz)80", "clock=80"), "2:26", "write it like (MHz)125");
    check_refused(with("clock=(MHz)80", "clock=(Mhz)80"), "2:26", "did you mean \"MHz\"?");
    check_refused(with("clock=(MHz)80", "clock=(kHz)80"), "2:26", "allowed: (MHz)1 to (MHz)2000");
    check_refused(with("clock=(MHz)80", "clock=fast"), "2:26", "a frequency is expected here");
    check_refused(with("clock=(MHz)80", ""), "2:5", "add clock=");
    check_refused(with("cycles=1.25", "cycles=0"), "2:41", "allowed: 0.25 to 20");
    check_refused(with("cycles=1.25", "cycle=1"), "2:34", "did you mean \"cycles\"?");
    check_refused(with("(KiB)512", "(KB)512"), "3:18", "did you mean \"KiB\"?");
    check_refused(with("(KiB)512", "(B)512"), "3:18", "allowed: (KiB)1 to (MiB)64");
    check_refused(with("parallel-8", "parallel"), "4:9", "did you mean \"parallel-8\"?");
    check_refused(with("320 172", "320"), "5:5", "a panel has a width and a height");
    check_refused(with("320 172", "320 5000"), "5:15", "allowed: 1 to 4096");
    check_refused(with("320 172", "321 172"), "5:5", "multiples of that");
    check_refused(with("320 172 ", "st7798 "), "5:11", "did you mean \"st7789\"?");
    check_refused(with("grey4", "gray4"), "5:26", "did you mean \"grey4\"?");
    check_refused(with("window=9", "window=-1"), "5:39", "allowed: 0 to 64");
    check_refused(with("(KiB)8", "(B)8"), "6:11", "allowed: (B)16 to (MiB)1");
    check_refused(with("reserved", "reserve"), "7:5", "did you mean \"reserved\"?");
    check_refused(with("ram=(KiB)3", "rom=(KiB)3"), "7:28", "did you mean \"ram\"?");
    check_refused(with("    bands", "    bus spi clock=(MHz)1\n    bands"), "6:5",
                  "\"bus\" stands here already, on line 4");
    check_refused(with("    panel 320 172 format=grey4 window=9\n", ""), "1:1", "this board has no panel");
}

TEST_CASE("texts that are no boards are told so")
{
    check_refused("", "1:1", "there is no board in this text");
    check_refused("kfast 1\ncanvas 240 240", "1:1", "write board NAME");
    check_refused(whole + "board b {}", "9:1", "one node");
    check_refused("board { ", "1:7", "closing }");
    check_refused("board a b {}", "1:9", "this value is too many for board");
    check_refused("board a size=1 {}", "1:9", "board has no property");
}

TEST_CASE("all mistakes are told at once")
{
    const std::string said = complaints("board a { core cortex-m9 clock=1; bus spy; panel x }");
    for (const char* what : {"cortex-m9", "a frequency needs a unit", "spy", "unknown panel", "no memory"})
        CHECK(said.find(what) != std::string::npos);
}

}
