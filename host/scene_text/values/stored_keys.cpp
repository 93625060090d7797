#include "host/scene_text/values/stored_keys.hpp"

#include "host/program/failure.hpp"
#include "host/scene/context/limits.hpp"

#include <iterator>

namespace kfast::scene_text {
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

}
