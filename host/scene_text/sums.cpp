#include "host/scene_text/sums.hpp"

#include <algorithm>
#include <functional>

namespace kfast::scene_text {
namespace {

using art::Channel;

/// Between two keys of either.
constexpr int most_steps = 16;

bool is_straight(const Channel& channel)
{
    return std::ranges::all_of(
        channel.keys, [](const art::Key<double>& key) { return key.ease.kind == art::EaseKind::linear; });
}

template <typename Operation>
Channel key_by_key(const Channel& left, const Channel& right, Operation operation)
{
    Channel result = left;
    for (std::size_t i = 0; i < result.keys.size(); ++i)
        result.keys[i].value = operation(left.keys[i].value, right.keys[i].value);
    return result;
}

std::vector<double> times_of(const Channel& left, const Channel& right)
{
    std::vector<double> times;
    for (const Channel* channel : {&left, &right})
        for (const auto& key : channel->keys)
            times.push_back(key.time);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

/// The ease of the way that leads from `time`: holds count, all else becomes straight.
bool holds(const Channel& channel, double time)
{
    const auto next = std::ranges::upper_bound(channel.keys, time, {}, &art::Key<double>::time);
    return next == channel.keys.begin() || next == channel.keys.end() ||
           std::prev(next)->ease.kind == art::EaseKind::hold;
}

template <typename Operation>
Channel sampled(const Channel& left, const Channel& right, Operation operation, int steps)
{
    const std::vector<double> times = times_of(left, right);
    Channel result{std::vector<art::Key<double>>{}};
    for (std::size_t i = 0; i < times.size(); ++i) {
        const bool both_hold = holds(left, times[i]) && holds(right, times[i]);
        const double next = i + 1 < times.size() ? times[i + 1] : times[i];
        const int pieces = next == times[i] || both_hold ? 1 : steps;
        for (int piece = 0; piece < pieces; ++piece) {
            const double time = art::mixed(times[i], next, static_cast<double>(piece) / pieces);
            result.keys.push_back({time,
                                   operation(left.at(time), right.at(time)),
                                   {both_hold ? art::EaseKind::hold : art::EaseKind::linear}});
        }
    }
    return result;
}

template <typename Operation>
Channel combined(const Channel& left, const Channel& right, Operation operation, bool is_exact)
{
    if (go_alike(left, right) && is_exact)
        return key_by_key(left, right, operation);
    return sampled(left, right, operation,
                   is_exact && is_straight(left) && is_straight(right) ? 1 : most_steps);
}

}

bool go_alike(const Channel& left, const Channel& right)
{
    return std::ranges::equal(left.keys, right.keys, [](const auto& one, const auto& other) {
        return one.time == other.time && one.ease == other.ease;
    });
}

bool has_sum(const Channel& left, const Channel& right)
{
    return left.is_still() || right.is_still() || go_alike(left, right);
}

bool has_product(const Channel& left, const Channel& right) { return left.is_still() || right.is_still(); }

Channel sum(const Channel& left, const Channel& right)
{
    if (right.is_still())
        return shifted(left, right.value());
    return left.is_still() ? shifted(right, left.value()) : combined(left, right, std::plus{}, true);
}

Channel difference(const Channel& left, const Channel& right) { return sum(left, scaled(right, -1)); }

Channel product(const Channel& left, const Channel& right)
{
    if (right.is_still())
        return scaled(left, right.value());
    return left.is_still() ? scaled(right, left.value()) : combined(left, right, std::multiplies{}, false);
}

Channel scaled(Channel channel, double factor)
{
    for (auto& key : channel.keys)
        key.value *= factor;
    return channel;
}

Channel shifted(Channel channel, double offset)
{
    for (auto& key : channel.keys)
        key.value += offset;
    return channel;
}

}
