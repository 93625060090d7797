#pragma once

#include "core/pixel/pixel_format.hpp"
#include "firmware/settings/board_settings.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace kfast {

/// What one must know of a display controller before anything is sent to it.
struct ControllerFacts {
    PanelSettings default_value; ///< the module that most people have
    Size memory;                 ///< pixels that it stores; a glass is within
    bool turns_across;           ///< whether it can rotate pictures by quarters; all can by halves
    PixelFormat format;   ///< of the picture; 16-bit colours are rgb565 or rgb565_be as the bus needs them
    Size granularity;     ///< positions and sizes of areas are multiples of it
    int window_bytes;     ///< what an area costs on the bus besides its pixels
    std::uint32_t spi_hz; ///< the fastest clock that the maker allows for writing, bits a second
    std::uint32_t parallel_hz; ///< of a parallel bus, writes a second; 0: none is supported
    std::uint32_t i2c_hz;      ///< of I²C; 0: none is supported

    constexpr bool takes(BusKind bus) const
    {
        return bus == BusKind::spi ? spi_hz != 0 : bus == BusKind::i2c ? i2c_hz != 0 : parallel_hz != 0;
    }
};

/// Column and row with two words each, and the command to write: the controllers that follow MIPI DCS.
inline constexpr int dcs_window_bytes = 5 + 5 + 1;

/// What most modules with a controller are, which decides what is printed on their pins.
enum class ModuleKind : std::uint8_t {
    lcd,         ///< with a backlight that has a pin
    colour_oled, ///< whose pixels shine
    mono_oled,   ///< whose pixels shine in one colour
};

/// A controller, as far as it is known before anything is sent to it. A device has only the name and the
/// facts of a row.
struct ControllerRow {
    std::string_view name;
    ModuleKind module;
    bool is_rated; ///< the clocks of its facts are the maker's own
    ControllerFacts facts;
};

/// In the order of Controller. Clocks are the write cycles of the makers' tables: a glass that has run faster
/// on somebody's desk is not rated for it.
inline constexpr std::array<ControllerRow, controller_count> controller_rows{
    ControllerRow{
        .name = "st7789",
        .module = ModuleKind::lcd,
        .is_rated = true,
        .facts = {.default_value = {.controller = Controller::st7789, .glass = {240, 240}, .inverted = true},
                  .memory = {240, 320},
                  .turns_across = true,
                  .format = PixelFormat::rgb565,
                  .granularity = {1, 1},
                  .window_bytes = dcs_window_bytes,
                  .spi_hz = 62'500'000,
                  .parallel_hz = 15'150'000,
                  .i2c_hz = 0}},
    ControllerRow{
        .name = "ili9341",
        .module = ModuleKind::lcd,
        .is_rated = true,
        .facts = {.default_value = {.controller = Controller::ili9341, .glass = {240, 320}, .bgr = true},
                  .memory = {240, 320},
                  .turns_across = true,
                  .format = PixelFormat::rgb565,
                  .granularity = {1, 1},
                  .window_bytes = dcs_window_bytes,
                  .spi_hz = 10'000'000,
                  .parallel_hz = 15'150'000,
                  .i2c_hz = 0}},
    ControllerRow{.name = "st7735",
                  .module = ModuleKind::lcd,
                  .is_rated = true,
                  .facts = {.default_value = {.controller = Controller::st7735,
                                              .glass = {128, 160},
                                              .column = 2,
                                              .row = 1,
                                              .bgr = true},
                            .memory = {132, 162},
                            .turns_across = true,
                            .format = PixelFormat::rgb565,
                            .granularity = {1, 1},
                            .window_bytes = dcs_window_bytes,
                            .spi_hz = 15'150'000,
                            .parallel_hz = 15'150'000,
                            .i2c_hz = 0}},
    ControllerRow{.name = "gc9a01",
                  .module = ModuleKind::lcd,
                  .is_rated = false, // spi_hz is from other sources: the maker's table was not at hand
                  .facts = {.default_value = {.controller = Controller::gc9a01,
                                              .glass = {240, 240},
                                              .bgr = true,
                                              .inverted = true},
                            .memory = {240, 240},
                            .turns_across = true,
                            .format = PixelFormat::rgb565,
                            .granularity = {1, 1},
                            .window_bytes = dcs_window_bytes,
                            .spi_hz = 100'000'000,
                            .parallel_hz = 0,
                            .i2c_hz = 0}},
    ControllerRow{.name = "ssd1306",
                  .module = ModuleKind::mono_oled,
                  .is_rated = true,
                  .facts = {.default_value = {.controller = Controller::ssd1306, .glass = {128, 64}},
                            .memory = {128, 64},
                            .turns_across = false,
                            .format = PixelFormat::mono1,
                            .granularity = {8, 8},
                            .window_bytes = 6,
                            .spi_hz = 10'000'000,
                            .parallel_hz = 0,
                            .i2c_hz = 400'000}},
    ControllerRow{.name = "ssd1351",
                  .module = ModuleKind::colour_oled,
                  .is_rated = true,
                  .facts = {.default_value = {.controller = Controller::ssd1351, .glass = {128, 128}},
                            .memory = {128, 128},
                            .turns_across = true,
                            .format = PixelFormat::rgb565,
                            .granularity = {1, 1},
                            .window_bytes = 7,
                            .spi_hz = 20'000'000,
                            .parallel_hz = 0,
                            .i2c_hz = 0}},
    ControllerRow{.name = "ssd0323",
                  .module = ModuleKind::mono_oled,
                  .is_rated = true,
                  .facts = {.default_value = {.controller = Controller::ssd0323, .glass = {128, 64}},
                            .memory = {128, 80},
                            .turns_across = false,
                            .format = PixelFormat::grey4,
                            .granularity = {2, 1},
                            .window_bytes = 6,
                            .spi_hz = 4'000'000,
                            .parallel_hz = 0,
                            .i2c_hz = 0}},
};

constexpr const ControllerRow& controller_row(Controller controller)
{
    return controller_rows[static_cast<std::size_t>(controller)];
}

static_assert(std::ranges::all_of(controller_rows,
                                  [](const ControllerRow& row) {
                                      return &row == &controller_row(row.facts.default_value.controller);
                                  }),
              "one row for each Controller, in its order");

/// One member of every row, in the order of Controller.
template <auto member>
constexpr auto controller_column()
{
    std::array<std::remove_cvref_t<decltype(controller_rows[0].*member)>, controller_count> column{};
    std::ranges::transform(controller_rows, column.begin(), member);
    return column;
}

// The types are written out because g++ 12 keeps in RAM what it has deduced.
inline constexpr std::array<std::string_view, controller_count> controller_names =
    controller_column<&ControllerRow::name>();
inline constexpr std::array<ControllerFacts, controller_count> controller_facts =
    controller_column<&ControllerRow::facts>();

constexpr std::string_view controller_name(Controller controller)
{
    return controller_names[static_cast<std::size_t>(controller)];
}

constexpr const ControllerFacts& facts_of(Controller controller)
{
    return controller_facts[static_cast<std::size_t>(controller)];
}

}
