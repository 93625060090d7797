#include "host/scene_text/values/sums.hpp"

#include <algorithm>

namespace kfast::scene_text {

using art::Channel;

bool go_alike(const Channel& left, const Channel& right)
{
    if (left.keys.size() != right.keys.size())
        return false;
    for (std::size_t i = 0; i < left.keys.size(); ++i) {
        const bool is_last = i + 1 == left.keys.size();
        if (left.keys[i].time != right.keys[i].time || (!is_last && left.keys[i].ease != right.keys[i].ease))
            return false;
    }
    return true;
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
    if (left.is_still())
        return shifted(right, left.value());
    Channel result = left;
    for (std::size_t i = 0; i < result.keys.size(); ++i)
        result.keys[i].value += right.keys[i].value;
    return result;
}

Channel product(const Channel& left, const Channel& right)
{
    return right.is_still() ? scaled(left, right.value()) : scaled(right, left.value());
}

Channel sum(const Channel& left, const Channel& right, const Sampling& sampling)
{
    if (has_sum(left, right))
        return sum(left, right);
    return art::baked_channel(
        [&](double time) {
            sampling.budget.take_computed_points(1);
            return left.at(time) + right.at(time);
        },
        baking_of({&left, &right}, sampling.tolerance));
}

Channel product(const Channel& left, const Channel& right, const Sampling& sampling)
{
    if (has_product(left, right))
        return product(left, right);
    return art::baked_channel(
        [&](double time) {
            sampling.budget.take_computed_points(1);
            return left.at(time) * right.at(time);
        },
        baking_of({&left, &right}, sampling.tolerance));
}

art::Baking baking_of(std::initializer_list<const Channel*> channels, double tolerance)
{
    art::Baking baking;
    baking.tolerance = tolerance;
    for (const Channel* channel : channels)
        for (const auto& key : channel->keys)
            baking.critical.push_back(key.time);
    const auto [first, last] = std::ranges::minmax(baking.critical);
    baking.from = first;
    baking.to = last;
    return baking;
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
