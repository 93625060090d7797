#include "host/scene/values/own_time.hpp"

#include "host/scene/context/limits.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace kfast::scene {

bool read_delay(const kdl::Value& value, UseTime& time, SceneContext& context)
{
    return assign(read_signed_time(value, context), time.delay);
}

bool read_speed(const kdl::Value& value, UseTime& time, SceneContext& context)
{
    const auto number = read_number(value, speeds, context.report);
    if (!number)
        return false;
    const auto speed = static_cast<std::int32_t>(std::lround(*number * Clock::normal_speed));
    if (speed == 0)
        return context.report.error(value.place, "at this speed nothing moves",
                                    "leave out speed=… or write another number");
    time.speed = speed;
    return true;
}

std::optional<Time> read_own_length(const kdl::Value& value, SceneContext& context)
{
    const auto length = read_time(value, context);
    if (!length || *length > Time{})
        return length;
    context.report.error(value.place, "a symbol with a time of its own cannot have the length 0");
    return std::nullopt;
}

namespace {

/// It has no end unless it needs one.
std::optional<Clock> clock_of(const UseTime& time, const SymbolEntry& symbol, SourceSpan place,
                              SceneContext& context)
{
    Clock clock{.delay = time.delay.value_or(Time{}),
                .speed = time.speed.value_or(Clock::normal_speed),
                .loop = symbol.length ? Loop::repeat : Loop::once,
                .length = symbol.length.value_or(Time{})};
    clock.loop = time.loop.value_or(symbol.loop.value_or(clock.loop));
    if (symbol.length || (clock.loop == Loop::once && clock.speed > 0))
        return clock;
    clock.length = symbol.last_key;
    if (clock.length != Time{})
        return clock;
    context.report.error(
        place, "the symbol " + in_quotes(symbol.name) + " has no length: it has no key after its beginning",
        "give it one with frames=…");
    return std::nullopt;
}

/// Notes where the symbol is used, and that it is not at the time around the use.
void note_use(const SymbolEntry& symbol, bool is_retimed, SymbolTable& symbols)
{
    SymbolEntry& entry = symbols.entries[symbols.number(symbol)];
    entry.is_retimed = entry.is_retimed || is_retimed;
    if (!symbols.in_progress.empty())
        entry.users.push_back(symbols.number(*symbols.in_progress.back()));
}

void warn_of_late_use(const Clock& clock, SourceSpan place, SceneContext& context)
{
    if (context.symbols.in_progress.empty() && context.length && clock.delay >= *context.length)
        context.report.warning(place, "the scene ends before this use of a symbol begins",
                               "make the scene longer with frames=… or the delay shorter");
}

/// What is rounded off a speed makes no scene a little longer than whole frames.
std::int64_t rounded_to_frame(std::int64_t ticks, std::int64_t length, std::int64_t speed)
{
    const std::int64_t frame =
        (ticks + Time::ticks_per_frame / 2) / Time::ticks_per_frame * Time::ticks_per_frame;
    const std::int64_t uncertainty = length * Clock::normal_speed / (2 * speed * speed) + 1;
    return std::abs(frame - ticks) <= uncertainty ? frame : ticks;
}

}

bool report_too_many_clocks(SourceSpan place, SceneContext& context)
{
    return context.report.error(
        place, "a scene holds at most " + std::to_string(max_clocks) + " different times of their own",
        "let uses have the same delay, speed and loop");
}

std::optional<Driver> own_driver(const UseTime& time, const SymbolEntry& symbol, SourceSpan place,
                                 SceneContext& context)
{
    const bool is_retimed = time.is_given() || symbol.length || symbol.loop;
    note_use(symbol, is_retimed, context.symbols);
    if (!is_retimed)
        return Driver{};
    const auto clock = clock_of(time, symbol, place, context);
    if (!clock)
        return std::nullopt;
    if (*clock == Clock{})
        return Driver{};
    warn_of_late_use(*clock, place, context);
    const auto known = std::ranges::find(context.clocks, *clock);
    const auto index = static_cast<std::size_t>(known - context.clocks.begin());
    if (index == max_clocks) {
        report_too_many_clocks(place, context);
        return std::nullopt;
    }
    if (known == context.clocks.end())
        context.clocks.push_back(*clock);
    return Driver::of_clock(index);
}

void take_pass(const SymbolEntry& symbol, Driver driver, SceneContext& context)
{
    std::int64_t end = symbol.last_key.ticks;
    if (driver.is_clock()) {
        const Clock& clock = context.clocks[driver.index()];
        const std::int64_t length = clock.length == Time{} ? symbol.last_key.ticks : clock.length.ticks;
        const std::int64_t speed = std::abs(clock.speed);
        const std::int64_t pass = (length * Clock::normal_speed + speed - 1) / speed;
        end = clock.delay.ticks + rounded_to_frame(pass, length, speed);
    }
    const std::int64_t latest = std::min<std::int64_t>(end, kfb::max_time);
    context.last_key =
        std::max(context.last_key, Time{static_cast<std::int32_t>(std::max(latest, std::int64_t{0}))});
}

}
