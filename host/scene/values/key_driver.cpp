#include "host/scene/values/key_driver.hpp"

#include "host/scene/values/input_user.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/property_rule.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace kfast::scene {

std::optional<Time> KeyDriver::read_moment(const kdl::Value& value, SceneContext& context) const
{
    if (!input_)
        return read_time(value, context);
    const Range range{input_->min / 1000.0, input_->max / 1000.0};
    const auto number = read_number(value, is_range_known_ ? range : input_values, context.report);
    if (!number)
        return std::nullopt;
    const double share = std::clamp((*number - range.low) / (range.high - range.low), 0.0, 1.0);
    return Time{static_cast<std::int32_t>(std::lround(share * whole_input.ticks))};
}

std::string_view KeyDriver::grain() const
{
    return is_time() ? "times are rounded to 1/1024 frame; choose another"
                     : "values are rounded to 1/65536 of the range of the input; choose another";
}

std::optional<KeyDriver> read_key_driver(const kdl::Value& value, SceneContext& context)
{
    const auto number = use_input(value, InputType::number, context);
    return number ? std::optional{KeyDriver{context.inputs, *number}} : std::nullopt;
}

void warn_of_idle_input(const kdl::Node& node, bool has_keys, SceneContext& context)
{
    if (!has_keys && has_property(node, "input"))
        context.report.warning(property_span(node, "input"), "this input moves nothing: there are no keys",
                               "add keys, or remove input=…");
}

void report_late_key(std::string_view noun, SourceSpan place, SceneContext& context)
{
    const std::string name{noun};
    SymbolTable& symbols = context.symbols;
    std::string what = "scene";
    if (!symbols.in_progress.empty()) {
        SymbolEntry& symbol = symbols.entries[symbols.number(*symbols.in_progress.back())];
        if (!symbol.length)
            return void(symbol.late_keys.emplace_back(name, place));
        what = "symbol";
    }
    context.report.warning(place, "the " + what + " ends before anything of this " + name + " is seen",
                           "make the " + what + " longer with frames=… or remove the " + name);
}

bool comes_later(std::string_view noun, PlacedMoment before, PlacedMoment at, const KeyDriver& driver,
                 SceneContext& context)
{
    if (before.time < at.time)
        return true;
    const std::string name{noun};
    const std::string moment{driver.noun()};
    const std::string line = context.report.line(before.place);
    if (at.time == before.time)
        return context.report.error(at.place,
                                    "there is a " + name + " at this " + moment + " already, on " + line,
                                    std::string{driver.grain()});
    return context.report.error(at.place,
                                "this " + name + " is " + (driver.is_time() ? "earlier" : "lower") +
                                    " than the one before it, on " + line,
                                "put the " + name + "s in the order of their " + moment + "s");
}

}
