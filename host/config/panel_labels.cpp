#include "host/config/panel_labels.hpp"

#include "firmware/settings/controller_facts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast::config {

namespace {

/// The kinds of labels printed on modules. For SPI it depends on the display.
enum class Print : std::uint8_t { lcd_spi, colour_oled_spi, mono_oled_spi, i2c, parallel, mcp4922 };

constexpr std::size_t print_count = 6;
constexpr std::size_t max_printed_names = 6;

/// What is known of a role's pin on a module.
struct PinRoleRow {
    PinRole role;
    IdleLevel idle; ///< where the pin goes that the display may have and no GPIO drives
    std::array<std::string_view, print_count> labels;                   ///< in the order of Print
    std::array<std::string_view, max_printed_names> printed_names = {}; ///< in small letters
};

/// In the order of PinRole. An MCP4922 has the numbers of its legs; the Z input is that of what it drives.
constexpr std::array<PinRoleRow, pin_role_names.size()> rows{
    PinRoleRow{PinRole::clock,
               IdleLevel::none,
               {"SCL, SCK or CLK", "SCL, SCK or CLK", "D0, CLK or SCK", "SCL or SCK", "WR", "SCK (4)"},
               {"sck", "scl", "sclk", "clk", "wr"}},
    PinRoleRow{PinRole::data,
               IdleLevel::none,
               {"SDA, MOSI or DIN", "SDA, MOSI or DIN", "D1, DIN or MOSI", "SDA", "D", "SDI (5)"},
               {"mosi", "sda", "sdi", "din", "tx", "d0"}},
    PinRoleRow{PinRole::select, IdleLevel::low, {"CS", "CS", "CS", "", "CS", "CS (3)"}, {"cs", "ce"}},
    PinRoleRow{PinRole::dc,
               IdleLevel::none,
               {"DC, RS or A0", "DC, RS or A0", "DC", "", "RS or DC", ""},
               {"rs", "a0"}},
    PinRoleRow{PinRole::reset,
               IdleLevel::high,
               {"RES or RST", "RES or RST", "RES or RST", "RES or RST", "RST or RES", ""},
               {"rst", "res"}},
    PinRoleRow{PinRole::backlight,
               IdleLevel::high,
               {"BLK, BL or LED", "", "", "", "BLK, BL or LED", ""},
               {"bl", "blk", "led"}},
    PinRoleRow{PinRole::tearing, IdleLevel::none, {"TE", "", "", "", "TE", ""}, {"te"}},
    PinRoleRow{PinRole::log, IdleLevel::none, {}, {"uart"}},
    PinRoleRow{PinRole::ldac, IdleLevel::none, {"", "", "", "", "", "LDAC (8)"}, {"load"}},
    PinRoleRow{PinRole::blank, IdleLevel::none, {"", "", "", "", "", "Z or BLANK"}, {"z"}},
};

constexpr const PinRoleRow& row_of(PinRole role) { return rows[static_cast<std::size_t>(role)]; }

static_assert(std::ranges::all_of(rows, [](const PinRoleRow& row) { return &row == &row_of(row.role); }),
              "one row for each PinRole, in its order");

Print print_by_spi(ModuleKind module)
{
    switch (module) {
    case ModuleKind::lcd:
        break;
    case ModuleKind::colour_oled:
        return Print::colour_oled_spi;
    case ModuleKind::mono_oled:
        return Print::mono_oled_spi;
    }
    return Print::lcd_spi;
}

Print print_of(const BoardSettings& settings)
{
    switch (settings.bus) {
    case BusKind::i2c:
        return Print::i2c;
    case BusKind::parallel_8:
        return Print::parallel;
    case BusKind::dac:
        return Print::mcp4922;
    case BusKind::spi:
        break;
    }
    return print_by_spi(controller_row(settings.panel.controller).module);
}

}

std::string_view panel_label(PinRole role, const BoardSettings& settings)
{
    return row_of(role).labels[static_cast<std::size_t>(print_of(settings))];
}

IdleLevel idle_level(PinRole role, const BoardSettings& settings)
{
    if (settings.pin(role) != no_pin || panel_label(role, settings).empty())
        return IdleLevel::none;
    return row_of(role).idle;
}

std::optional<PinRole> role_printed_as(std::string_view name)
{
    if (name.empty())
        return std::nullopt;
    const auto row = std::ranges::find_if(rows, [name](const PinRoleRow& role) {
        return std::ranges::find(role.printed_names, name) != role.printed_names.end();
    });
    return row == rows.end() ? std::nullopt : std::optional{row->role};
}

}
