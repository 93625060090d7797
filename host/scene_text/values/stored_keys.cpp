#include "host/scene_text/values/stored_keys.hpp"

#include "host/program/failure.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene_text/values/grid.hpp"
#include "host/words/law_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace kfast::scene_text {

namespace {

using art::Ease;
using art::EaseKind;

using StoredControls = std::array<std::int32_t, 4>;

StoredControls stored(const std::array<double, 4>& numbers)
{
    StoredControls result{};
    std::ranges::transform(numbers, result.begin(), [](double number) { return on_grid(number, controls); });
    return result;
}

std::string law_of(const StoredControls& numbers)
{
    const auto at = [&numbers](std::size_t i) { return static_cast<std::int16_t>(numbers[i]); };
    const auto keyword = keyword_of(VelocityLaw::bezier(at(0), at(1), at(2), at(3)));
    if (!keyword.empty())
        return std::string{keyword};
    std::string text{word_of(VelocityLaw::Kind::bezier).keyword};
    text += '(';
    for (const std::int32_t& control : numbers)
        text += decimal(control, controls) + (&control == &numbers.back() ? ')' : ',');
    return text;
}

}

std::string law_of(const Ease& ease)
{
    if (ease.kind == EaseKind::hold)
        return std::string{keyword_of(VelocityLaw::hold)};
    if (ease.kind == EaseKind::linear)
        return std::string{keyword_of(VelocityLaw::constant)};
    const StoredControls numbers =
        stored({std::clamp(ease.x1, 0.0, 1.0), ease.y1, std::clamp(ease.x2, 0.0, 1.0), ease.y2});
    if (numbers[0] == numbers[1] && numbers[2] == numbers[3])
        return std::string{keyword_of(VelocityLaw::constant)};
    return law_of(numbers);
}

namespace {

bool is_law(const art::Ease& ease)
{
    const auto [low, high] = std::minmax(ease.y1, ease.y2);
    return ease.kind != art::EaseKind::cubic || (low >= controls.low && high <= controls.high);
}

}

std::vector<art::EasePart> law_parts(const art::Ease& ease)
{
    if (is_law(ease))
        return ease_parts(ease, 0, 1);
    // What is divided has control points within bounds.
    std::vector<art::EasePart> parts = ease_parts(ease, 0, 0.5);
    std::ranges::move(ease_parts(ease, 0.5, 1), std::back_inserter(parts));
    return parts;
}

void check_count(std::size_t keys)
{
    if (keys > scene::max_keys)
        throw Failure("something has more than " + std::to_string(scene::max_keys) +
                      " keys, the most in a scene; leave out some, or allow a larger --tolerance");
}

void check_step(double pixels)
{
    if (std::abs(pixels) > coordinates.high)
        throw Failure("copies of something are more than 2047 pixels from each other; draw it smaller");
}

void part_ticks(std::vector<std::int32_t>& ticks, std::int32_t length)
{
    for (std::size_t i = 1; i < ticks.size(); ++i)
        ticks[i] = std::max(ticks[i], ticks[i - 1] + 1);
    std::int32_t latest = length;
    for (auto tick = ticks.rbegin(); tick != ticks.rend(); ++tick) {
        *tick = std::min(*tick, latest);
        latest = *tick - 1;
    }
}

std::vector<StoredKey<std::int32_t>> stored_keys(const art::Channel& channel, std::int32_t length,
                                                 const Grid& grid)
{
    return stored_keys(channel, length, [&](double value) { return on_grid(value, grid); });
}

namespace {

/// The ticks of a time that may be outside of the scene, or infinite.
std::int32_t ticks_within(double time, std::int32_t length) { return std::min(on_grid(time, times), length); }

}

std::int32_t length_of(const art::Symbol& symbol) { return std::max(on_grid(symbol.frames, times), 1); }

std::vector<StoredKey<bool>> visible_keys(const std::vector<art::Span>& shown, std::int32_t length)
{
    std::vector<StoredKey<bool>> keys{{0, false}};
    for (const art::Span& span : shown) {
        const std::int32_t from = ticks_within(span.from, length);
        const std::int32_t to = ticks_within(span.to, length);
        if (from >= to)
            continue;
        if (keys.back().ticks == from)
            keys.pop_back();
        if (keys.empty() || !keys.back().value)
            keys.push_back({from, true});
        if (to < length)
            keys.push_back({to, false});
    }
    return keys;
}

}
