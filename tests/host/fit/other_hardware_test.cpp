#include "host/fit/other_hardware.hpp"

#include "host/fit/board_reader.hpp"
#include "host/fit/board_texts.hpp"
#include "host/fit/display.hpp"
#include "host/picture/panel_choice.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <set>
#include <sstream>

namespace kfast::fit {
namespace {

bool says(const std::optional<std::string>& text, std::string_view part)
{
    return text && text->find(part) != std::string::npos;
}

/// Every name of these, which must be small letters and digits, and stand there once.
void check_names(const std::vector<OtherName>& others)
{
    std::set<std::string> all;
    for (const OtherName& other : others) {
        CHECK_FALSE(other.what.empty());
        CHECK_FALSE(other.hint.empty());
        std::istringstream names{std::string{other.names}};
        for (std::string name; names >> name;) {
            CAPTURE(name);
            CHECK(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789") == std::string::npos);
            CHECK(all.insert(name).second);
        }
    }
}

}

TEST_CASE("a board that is not supported is called by its name, and described")
{
    for (const char* const name : {"pico2", "Pico 2", "pico_2-w", "RP2350"}) {
        CAPTURE(name);
        const auto advice = other_board_advice(name);
        CHECK(says(advice, "a Pico 2 (RP2350, Cortex-M33) is not supported yet"));
        CHECK(says(advice, "board my-pico2 {"));
        CHECK(says(advice, "--board my-pico2.kdl"));
        CHECK(says(advice, "core cortex-m33 clock=(MHz)150"));
    }
    for (const char* const name : {"esp32", "esp32-s3", "ESP32-C3"})
        CHECK(says(other_board_advice(name), "core cortex-m4 clock="));
    CHECK(says(other_board_advice("STM32F407"), "core cortex-m4 clock=(MHz)168"));
    CHECK_FALSE(other_board_advice("pica"));
    CHECK_FALSE(other_board_advice(""));
    CHECK_FALSE(other_board_advice("-"));
}

TEST_CASE("a board that no description helps has none, and a remedy")
{
    for (const char* const name : {"arduino uno", "AVR", "mega2560"}) {
        CHECK(says(other_board_advice(name), "take a board of 32 bits"));
        CHECK(other_board_advice(name) == other_board_text(name));
    }
    CHECK(says(other_board_advice("pico-w"), "take pico"));
    CHECK(says(other_board_advice("Raspberry Pi 4"), "kfast panel"));
}

TEST_CASE("what is printed for a board describes one, without a mistake")
{
    std::size_t described = 0;
    for (const OtherBoard& board : other_boards()) {
        const std::string text = board_file(board);
        if (text.empty())
            continue;
        CAPTURE(text);
        Diagnostics diagnostics;
        const auto target = read_board({"my.kdl", text}, diagnostics);
        CHECK(diagnostics.sorted().empty());
        REQUIRE(target);
        CHECK(target->name.starts_with("my-"));
        CHECK(target->bus.clock <= target->display.rated_spi);
        CHECK(std::ranges::count(text, '\n') <= 10);
        ++described;
    }
    CHECK(described > 10);
}

TEST_CASE("names of other hardware are plain, stand once, and are not those of what is known")
{
    std::vector<OtherName> boards;
    std::ranges::transform(other_boards(), std::back_inserter(boards), &OtherBoard::name);
    check_names(boards);
    check_names({other_cores().begin(), other_cores().end()});
    check_names({other_panels().begin(), other_panels().end()});
    for (const BoardText& board : board_texts())
        CHECK_FALSE(other_board_text(board.name));
    for (const Display& display : displays())
        CHECK_FALSE(other_panel_text(display.name));
    CHECK(says(other_core_text("cortex-m55"), "take cortex-m33"));
    CHECK_FALSE(other_core_text("cortex-m33"));
}

TEST_CASE("all panels that the preview and settings know are known to fit, and those alone have drivers")
{
    std::size_t driven = 0;
    for (const Display& display : displays()) {
        CAPTURE(display.name);
        const bool is_choice = std::ranges::any_of(
            panel_choices(), [&](const PanelChoice& choice) { return choice.name == display.name; });
        CHECK(is_choice == display.is_driven);
        CHECK(undriven_panel_text(display.name).has_value() == !display.is_driven);
        driven += display.is_driven ? 1 : 0;
    }
    CHECK(driven == panel_choices().size());
    CHECK(says(undriven_panel_text("ssd1322"), "kfast fit alone knows it"));
    CHECK(says(undriven_panel_text("ssd1322"), "--size 256x64 --format grey4"));
    CHECK(says(undriven_panel_text("SH1106"), "pages of 8 rows"));
    CHECK(says(undriven_panel_text("ST7920"), "words of 16 pixels"));
    CHECK(says(undriven_panel_text("SSD1305"), "try ssd1306"));
    CHECK(says(undriven_panel_text("e-paper"), "too long for animations"));
    CHECK_FALSE(undriven_panel_text("nothing"));
}

}
