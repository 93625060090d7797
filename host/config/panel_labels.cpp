#include "host/config/panel_labels.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace kfast::config {

namespace {

/// In the order of PinRole.
using Labels = std::array<std::string_view, pin_role_names.size()>;

constexpr Labels colour_by_spi{"SCL, SCK or CLK", "SDA, MOSI or DIN", "CS", "DC, RS or A0",
                               "RES or RST",      "BLK, BL or LED",   "TE"};
constexpr Labels lit_by_spi{
    "SCL, SCK or CLK", "SDA, MOSI or DIN", "CS", "DC, RS or A0", "RES or RST", "", ""};
constexpr Labels mono_by_spi{"D0, CLK or SCK", "D1, DIN or MOSI", "CS", "DC", "RES or RST", "", ""};
constexpr Labels by_i2c{"SCL or SCK", "SDA", "", "", "RES or RST", "", ""};
constexpr Labels parallel{"WR", "D", "CS", "RS or DC", "RST or RES", "BLK, BL or LED", "TE"};
/// The legs of an MCP4922, and the Z input of what it leads.
constexpr Labels dac{"SCK (4)", "SDI (5)", "CS (3)", "", "", "", "", "", "LDAC (8)", "Z or BLANK"};

const Labels& labels_by_spi(Controller controller)
{
    switch (controller) {
    case Controller::st7789:
    case Controller::ili9341:
    case Controller::st7735:
    case Controller::gc9a01:
        break;
    case Controller::ssd1351:
        return lit_by_spi;
    case Controller::ssd1306:
    case Controller::ssd0323:
        return mono_by_spi;
    }
    return colour_by_spi;
}

const Labels& labels_of(const BoardSettings& settings)
{
    switch (settings.bus) {
    case BusKind::i2c:
        return by_i2c;
    case BusKind::parallel_8:
        return parallel;
    case BusKind::dac:
        return dac;
    case BusKind::spi:
        break;
    }
    return labels_by_spi(settings.panel.controller);
}

}

std::string_view panel_label(PinRole role, const BoardSettings& settings)
{
    return labels_of(settings)[static_cast<std::size_t>(role)];
}

IdleLevel idle_level(PinRole role, const BoardSettings& settings)
{
    if (settings.pin(role) != no_pin || panel_label(role, settings).empty())
        return IdleLevel::none;
    switch (role) {
    case PinRole::select:
        return IdleLevel::low;
    case PinRole::reset:
    case PinRole::backlight:
        return IdleLevel::high;
    case PinRole::clock:
    case PinRole::data:
    case PinRole::dc:
    case PinRole::tearing:
    case PinRole::log:
    case PinRole::ldac:
    case PinRole::blank:
        break;
    }
    return IdleLevel::none;
}

namespace {

struct PrintedName {
    std::string_view name;
    PinRole role;
};

constexpr std::array printed_names{
    PrintedName{"sck", PinRole::clock},     PrintedName{"scl", PinRole::clock},
    PrintedName{"sclk", PinRole::clock},    PrintedName{"clk", PinRole::clock},
    PrintedName{"wr", PinRole::clock},      PrintedName{"mosi", PinRole::data},
    PrintedName{"sda", PinRole::data},      PrintedName{"sdi", PinRole::data},
    PrintedName{"din", PinRole::data},      PrintedName{"tx", PinRole::data},
    PrintedName{"d0", PinRole::data},       PrintedName{"cs", PinRole::select},
    PrintedName{"ce", PinRole::select},     PrintedName{"rs", PinRole::dc},
    PrintedName{"a0", PinRole::dc},         PrintedName{"rst", PinRole::reset},
    PrintedName{"res", PinRole::reset},     PrintedName{"bl", PinRole::backlight},
    PrintedName{"blk", PinRole::backlight}, PrintedName{"led", PinRole::backlight},
    PrintedName{"te", PinRole::tearing},    PrintedName{"uart", PinRole::log},
    PrintedName{"z", PinRole::blank},       PrintedName{"load", PinRole::ldac},
};

}

std::optional<PinRole> role_printed_as(std::string_view name)
{
    const auto printed = std::ranges::find(printed_names, name, &PrintedName::name);
    return printed == printed_names.end() ? std::nullopt : std::optional{printed->role};
}

}
