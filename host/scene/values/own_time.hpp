#pragma once

#include "core/time/clock.hpp"
#include "core/time/time.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/context/tables.hpp"
#include "host/scene/values/value_reader.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace kfast::scene {

/// When and how fast the use of a symbol runs, as far as it says so.
struct UseTime {
    std::optional<Time> delay;         ///< may be negative: then it has already begun
    std::optional<std::int32_t> speed; ///< Clock::speed, not 0
    std::optional<Loop> loop;

    bool is_given() const { return delay || speed || loop; }
};

bool read_delay(const kdl::Value& value, UseTime& time, SceneContext& context);
bool read_speed(const kdl::Value& value, UseTime& time, SceneContext& context);

inline constexpr Range speeds{-16, 16};

/// The rules of something that has a UseTime, its `time`.
template <class Target>
inline constexpr std::array own_time_rules{
    PropertyRule<Target>{"delay",
                         [](const kdl::Value& value, Target& target, SceneContext& context) {
                             return read_delay(value, target.time, context);
                         },
                         any_time},
    PropertyRule<Target>{"speed",
                         [](const kdl::Value& value, Target& target, SceneContext& context) {
                             return read_speed(value, target.time, context);
                         },
                         ValueKind::number(speeds)},
    PropertyRule<Target>{"loop",
                         [](const kdl::Value& value, Target& target, SceneContext& context) {
                             return assign(read_loop(value, context), target.time.loop);
                         },
                         ValueKind::one_of<loops>()},
};

/// Reads the length of a symbol, at least one tick.
std::optional<Time> read_own_length(const kdl::Value& value, SceneContext& context);

/// Returns false.
bool report_too_many_clocks(SourceSpan place, SceneContext& context);

/// What the keys of a symbol go by where it is used: the time around it, or a clock of `context.clocks`.
/// `place` is that of the use. Nothing, and an error, if it repeats and has no length.
std::optional<Driver> own_driver(const UseTime& time, const SymbolEntry& symbol, SourceSpan place,
                                 SceneContext& context);

/// Notes how long the scene has to be for one pass of the symbol, by `driver`, as own_driver() returned it.
void take_pass(const SymbolEntry& symbol, Driver driver, SceneContext& context);

}
