#include "host/config/pins_reader.hpp"

#include "firmware/rp2040_pins.hpp"
#include "host/config/setting_words.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace kfast::config {
namespace {

using scene::Range, scene::Reading;

constexpr Range numbers{0, rp2040::pin_count - 1};

/// What sellers of displays print beside a pin.
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
};

bool report_unknown_role(const kdl::Node& node, const kdl::Property& property, Reading& reading)
{
    const auto printed = std::ranges::find(printed_names, property.name, &PrintedName::name);
    if (printed == printed_names.end())
        return report_unknown_property(node, property, pin_role_names, reading);
    const std::string role = word_of(printed->role);
    return reading.report.error(property.name_place, "pins has no property " + quoted(property.name),
                                "here it is called " + role + ": write " + role + "=…");
}

bool read_role(const kdl::Node& node, const kdl::Property& property, Draft& draft, Reading& reading)
{
    const auto name = std::ranges::find(pin_role_names, property.name);
    if (name == pin_role_names.end())
        return report_unknown_role(node, property, reading);
    Pin& pin = draft.settings.pins[static_cast<std::size_t>(name - pin_role_names.begin())];
    return scene::assign(read_pin(property.value, reading), pin);
}

}

std::optional<Pin> read_pin(const kdl::Value& value, scene::Reading& reading)
{
    if (value.number() == nullptr) {
        reading.report.error(value.place, "the number of a GPIO is expected here", "write 18 for GP18");
        return std::nullopt;
    }
    Pin pin = no_pin;
    return scene::assign(read_whole_number(value, numbers, reading), pin) ? std::optional{pin} : std::nullopt;
}

bool read_pins(const kdl::Node& node, Draft& draft, scene::Reading& reading)
{
    draft.pins = &node;
    bool good = true;
    for (const kdl::Property& property : node.properties)
        good = read_role(node, property, draft, reading) && good;
    return good;
}

}
