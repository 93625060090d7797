#include "host/config/pins_reader.hpp"

#include "firmware/settings/rp2040_pins.hpp"
#include "host/config/printed_roles.hpp"
#include "host/config/setting_words.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/value_reader.hpp"
#include "host/text/glyph.hpp"

#include <algorithm>
#include <string>

namespace kfast::config {
namespace {

using schema::Range, schema::Report;

constexpr Range numbers{0, rp2040::pin_count - 1};

bool report_unknown_role(const kdl::Node& node, const kdl::Property& property, Report& report)
{
    const std::optional<PinRole> printed = role_printed_as(property.name);
    if (!printed)
        return report_unknown_property(node, property, pin_role_names, report);
    const std::string role = word_of(*printed);
    return report.error(property.name_span, "pins has no property " + in_quotes(property.name),
                        "here it is called " + role + ": write " + role + "=…");
}

bool read_role(const kdl::Node& node, const kdl::Property& property, Draft& draft, Report& report)
{
    const auto name = std::ranges::find(pin_role_names, property.name);
    if (name == pin_role_names.end())
        return report_unknown_role(node, property, report);
    Pin& pin = draft.settings.pins[static_cast<std::size_t>(name - pin_role_names.begin())];
    return schema::assign(read_pin(property.value, report), pin);
}

}

std::optional<Pin> read_pin(const kdl::Value& value, schema::Report& report)
{
    if (value.number() == nullptr) {
        report.error(value.place, "the number of a GPIO is expected here", "write 18 for GP18");
        return std::nullopt;
    }
    Pin pin = no_pin;
    return schema::assign(read_whole_number(value, numbers, report), pin) ? std::optional{pin} : std::nullopt;
}

bool read_pins(const kdl::Node& node, Draft& draft, schema::Report& report)
{
    draft.pins = &node;
    bool good = true;
    for (const kdl::Property& property : node.properties)
        good = read_role(node, property, draft, report) && good;
    return good;
}

}
