#include "host/scene/key_clock.hpp"

#include "host/kdl/canonical.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace kfast::scene {

std::optional<Time> KeyClock::read_moment(const kdl::Value& value, Reading& reading) const
{
    if (!input_)
        return read_time(value, reading);
    const Range range{input_->least / 1000.0, input_->most / 1000.0};
    const auto number = read_number(value, is_range_known_ ? range : input_values, reading);
    if (!number)
        return std::nullopt;
    const double share = std::clamp((*number - range.low) / (range.high - range.low), 0.0, 1.0);
    return Time{static_cast<std::int32_t>(std::lround(share * whole_input.ticks))};
}

std::string_view KeyClock::grain() const
{
    return is_time() ? "times are rounded to 1/1024 frame; choose another"
                     : "values are rounded to 1/65536 of the range of the input; choose another";
}

std::optional<KeyClock> read_key_clock(const kdl::Value& value, Reading& reading)
{
    const auto name = read_name(value, reading);
    if (!name)
        return std::nullopt;
    InputTable& inputs = reading.inputs;
    if (InputEntry* const entry = inputs.find(*name)) {
        entry->is_used = true;
        return KeyClock{inputs, static_cast<std::size_t>(entry - inputs.entries.data())};
    }
    std::vector<std::string_view> known;
    for (const InputEntry& entry : inputs.entries)
        known.push_back(entry.input.name);
    reading.report.error(value.place, "unknown input " + quoted(*name),
                         known.empty()
                             ? "add \"input " + kdl::string_form(*name) + " min=0 max=1\" to the scene"
                             : suggestion(*name, known));
    return std::nullopt;
}

void warn_of_idle_input(const kdl::Node& node, bool has_keys, Reading& reading)
{
    if (!has_keys && has_property(node, "input"))
        reading.report.warning(property_place(node, "input"), "this input moves nothing: there are no keys",
                               "add keys, or remove input=…");
}

}
