#include "host/config/bus_reader.hpp"

#include "host/config/named_words.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/quantity_reader.hpp"

#include <array>
#include <cmath>

namespace kfast::config {
namespace {

using scene::assign, scene::PropertyRule, scene::Range, scene::Reading;

constexpr Range clocks{1, 1e9};
constexpr Range bytes{0, 0xFF}; // the rules know which addresses there are

constexpr std::array bus_words = named_words<BusKind>(bus_names);

bool read_clock(const kdl::Value& value, Draft& draft, Reading& reading)
{
    const auto clock = read_quantity(value, scene::frequency, clocks, reading);
    if (clock)
        draft.clock = static_cast<std::uint32_t>(std::lround(*clock));
    return clock.has_value();
}

bool read_address(const kdl::Value& value, Draft& draft, Reading& reading)
{
    return assign(read_whole_number(value, bytes, reading), draft.settings.i2c_address);
}

constexpr std::array rules{
    PropertyRule<Draft>{"clock", read_clock},
    PropertyRule<Draft>{"address", read_address},
};

}

bool read_bus(const kdl::Node& node, Draft& draft, scene::Reading& reading)
{
    draft.bus = &node;
    const bool is_known = assign(read_word(node.arguments.front(), bus_words, reading), draft.settings.bus);
    if (is_known && draft.settings.bus != BusKind::i2c && scene::has_property(node, "address"))
        reading.report.warning(scene::property_place(node, "address"), "only i2c has addresses", "remove it");
    return read_properties(node, rules, draft, reading) && is_known;
}

}
