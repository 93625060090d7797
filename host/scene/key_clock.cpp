#include "host/scene/key_clock.hpp"

#include "core/input_view.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

#include <vector>

namespace kfast::scene {

std::optional<Time> KeyClock::read_moment(const kdl::Value& value, Reading& reading) const
{
    if (!input_)
        return read_time(value, reading);
    const auto number = read_number(value, {input_->least / 1000.0, input_->most / 1000.0}, reading);
    if (!number)
        return std::nullopt;
    const InputView scale{.name = {}, .least = input_->least, .most = input_->most, .usual = 0};
    return scale.place_of(thousandths(*number));
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
                         known.empty() ? "add \"input " + visible(*name) + " min=0 max=1\" to the scene"
                                       : suggestion(*name, known));
    return std::nullopt;
}

}
