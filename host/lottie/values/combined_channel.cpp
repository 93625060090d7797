#include "host/lottie/values/combined_channel.hpp"

#include "host/art/animation/baked_drawing.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace kfast::lottie {

art::Channel combined(const std::function<double(double)>& value_at,
                      std::initializer_list<const art::Channel*> channels, Dependence dependence,
                      double tolerance, art::Budget& budget)
{
    std::vector<const art::Channel*> moving;
    std::ranges::copy_if(channels, std::back_inserter(moving),
                         [](const art::Channel* channel) { return !channel->is_still(); });
    if (moving.empty())
        return {value_at(0)};
    if (dependence == Dependence::linear && moving.size() == 1) {
        art::Channel result = *moving.front();
        for (auto& key : result.keys)
            key.value = value_at(key.time);
        return result;
    }
    art::Baking baking;
    baking.from = moving.front()->keys.front().time;
    baking.to = baking.from;
    baking.tolerance = tolerance;
    for (const art::Channel* channel : moving)
        for (const auto& key : channel->keys) {
            baking.from = std::min(baking.from, key.time);
            baking.to = std::max(baking.to, key.time);
            baking.critical.push_back(key.time);
        }
    constexpr double asked_each_frame = 4;
    constexpr double max_asked = 1 << 27;
    budget.take_computed_points(
        static_cast<std::size_t>(std::min(asked_each_frame * (baking.to - baking.from), max_asked)));
    return art::baked_channel(value_at, baking);
}

}
