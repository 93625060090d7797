#include "host/scene/values/dash_reader.hpp"

#include "core/math/dashes.hpp"
#include "host/schema/expression.hpp"
#include "host/schema/value_reader.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene {
namespace {

constexpr std::size_t max_lengths = Dashes::max_lengths;
constexpr Range lengths{0, max_dash_pixels};

Property length_at(std::size_t index)
{
    return static_cast<Property>(static_cast<std::size_t>(Property::dash_1) + index);
}

constexpr std::string_view separators = " \t,";

/// Where the length that begins there ends: at the next separator that stands in no parentheses.
std::size_t end_of_length(std::string_view text, std::size_t at)
{
    for (int depth = 0; at < text.size(); ++at) {
        if (depth <= 0 && separators.find(text[at]) != separators.npos)
            break;
        depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
    }
    return at;
}

/// Numbers, or expressions, with commas or spaces between them.
std::optional<std::vector<double>> listed_lengths(const kdl::Value& value, std::string_view text,
                                                  SceneContext& context)
{
    std::vector<double> listed;
    for (std::size_t at = text.find_first_not_of(separators); at < text.size();
         at = text.find_first_not_of(separators, at)) {
        const std::size_t end = end_of_length(text, at);
        auto found = schema::evaluate(text.substr(at, end - at), context.variables);
        if (found.finding)
            found.finding->place.offset += at;
        const auto length = schema::result_of(found, value, context.report);
        if (!length)
            return std::nullopt;
        listed.push_back(*length);
        at = end;
    }
    return listed;
}

std::optional<std::vector<double>> read_lengths(const kdl::Value& value, SceneContext& context)
{
    const std::string* const text = value.string();
    if (text != nullptr)
        return listed_lengths(value, *text, context);
    const auto length = read_number(value, lengths, context.report);
    return length ? std::optional{std::vector{*length}} : std::nullopt;
}

}

bool read_dash(const kdl::Value& value, ItemValues& values, SceneContext& context)
{
    const auto listed = read_lengths(value, context);
    if (!listed)
        return false;
    const std::size_t count = listed->size() % 2 == 0 ? listed->size() : 2 * listed->size();
    if (listed->empty() || count > max_lengths)
        return context.report.error(value.place, "a pattern has 1, 2, 3, 4 or 6 lengths",
                                    "write a dash and a gap, as in \"8 4\"");
    for (std::size_t i = 0; i < count; ++i) {
        const double length = (*listed)[i % listed->size()];
        if (!(length >= lengths.low && length <= lengths.high)) {
            report_out_of_range(value, lengths, context.report);
            return false;
        }
        values[length_at(i)] = static_cast<std::int32_t>(std::lround(length * dash_pixel));
    }
    return true;
}

std::size_t dash_length_count(const ItemValues& values)
{
    std::size_t count = 0;
    while (count < max_lengths && values.get(length_at(count)))
        ++count;
    return count;
}

void repeat_dash_lengths(ItemValues& values, std::size_t count)
{
    for (std::size_t i = dash_length_count(values), own = i; own != 0 && i < count; ++i)
        values[length_at(i)] = values.get(length_at(i - own));
}

}
