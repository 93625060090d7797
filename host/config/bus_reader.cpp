#include "host/config/bus_reader.hpp"

#include "host/config/named_words.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/quantity_reader.hpp"

#include <array>
#include <cmath>

namespace kfast::config {
namespace {

using schema::assign, schema::PropertyRule, schema::Range, schema::Report;

constexpr Range clocks{1, 1e9};
constexpr Range bytes{0, 0xFF}; // the rules know which addresses there are

constexpr std::array bus_words = named_words<BusKind>(bus_names);

bool read_clock(const kdl::Value& value, Draft& draft, Report& report)
{
    const auto clock = read_quantity(value, schema::frequency, clocks, report);
    if (clock)
        draft.clock = static_cast<std::uint32_t>(std::lround(*clock));
    return clock.has_value();
}

bool read_address(const kdl::Value& value, Draft& draft, Report& report)
{
    return assign(read_whole_number(value, bytes, report), draft.settings.i2c_address);
}

constexpr std::array rules{
    PropertyRule<Draft>{"clock", read_clock},
    PropertyRule<Draft>{"address", read_address},
};

}

bool read_bus(const kdl::Node& node, Draft& draft, schema::Report& report)
{
    draft.bus = &node;
    const bool is_known = assign(read_word(node.arguments.front(), bus_words, report), draft.settings.bus);
    if (is_known && draft.settings.bus != BusKind::i2c && schema::has_property(node, "address"))
        report.warning(schema::property_span(node, "address"), "only i2c has addresses", "remove it");
    return read_properties(node, rules, draft, report) && is_known;
}

}
