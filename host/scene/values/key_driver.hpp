#pragma once

#include "core/time/time.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/context/tables.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// What keys go by, and so what their times are as they are written: times, or values of an input.
class KeyDriver {
public:
    /// The time of the scene.
    KeyDriver() = default;
    /// The input `number` of `inputs`.
    KeyDriver(const InputTable& inputs, std::size_t number)
        : input_{inputs.entries[number].input},
          is_range_known_{inputs.entries[number].is_range_known},
          driver_{static_cast<std::uint8_t>(number + 1)}
    {
    }

    Driver driver() const { return driver_; }
    bool is_time() const { return driver_.is_time(); }
    /// Reports what is wrong with `value` and then returns nothing.
    std::optional<Time> read_moment(const kdl::Value& value, SceneContext& context) const;
    /// The word for it: "time" or "value".
    std::string_view noun() const { return is_time() ? "time" : "value"; }
    /// The smallest difference of two of them, in words.
    std::string_view grain() const;

private:
    std::optional<Input> input_;
    bool is_range_known_ = true;
    Driver driver_;
};

/// Reads a property `input=NAME`; the input is in use then.
std::optional<KeyDriver> read_key_driver(const kdl::Value& value, SceneContext& context);

/// Warns of a property `input` of `node`, an item, that has no keys itself.
void warn_of_idle_input(const kdl::Node& node, bool has_keys, SceneContext& context);

/// For the table of properties of something that has a `driver`.
template <class Target>
bool read_own_driver(const kdl::Value& value, Target& target, SceneContext& context)
{
    const auto driver = read_key_driver(value, context);
    if (driver)
        target.driver = *driver;
    return driver.has_value();
}

/// Where and when something is.
struct PlacedMoment {
    Time time;
    SourceSpan place;
};

/// Whether `at`, a `noun` such as "key", is later than `before` on their `driver`, and reports it if not.
bool comes_later(std::string_view noun, PlacedMoment before, PlacedMoment at, const KeyDriver& driver,
                 SceneContext& context);

/// Warns of a key, or whatever `noun` calls it, of which nothing is seen because the scene or the symbol that
/// it is in ends before. In a symbol that has no length of its own, only later: warn_of_late_keys().
void report_late_key(std::string_view noun, SourceSpan place, SceneContext& context);

/// Reports the first of `keys` of which nothing is seen because the scene, or a symbol, ends before. Their
/// times rise. Of those that are at the end or after it, the first `in_use` still shape what is seen.
template <class Key>
void look_for_late_keys(const std::vector<Key>& keys, std::ptrdiff_t in_use, std::string_view noun,
                        SceneContext& context)
{
    if (!context.length)
        return;
    const auto begins_too_late = [&](const Key& key) { return key.time >= *context.length; };
    const auto late = std::ranges::find_if(keys, begins_too_late);
    if (keys.end() - late > in_use)
        report_late_key(noun, (late + in_use)->place, context);
}

/// The same; also notes the time that `keys` extend to.
template <class Key>
void take_times(const std::vector<Key>& keys, std::ptrdiff_t in_use, std::string_view noun,
                SceneContext& context)
{
    look_for_late_keys(keys, in_use, noun, context);
    if (!keys.empty())
        context.last_key = std::max(context.last_key, keys.back().time);
}

}
