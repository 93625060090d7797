#include "host/scene_text/bones/bone_keys.hpp"

#include "host/scene_text/values/grid.hpp"
#include "host/scene_text/values/law_text.hpp"
#include "host/scene_text/values/stored_keys.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kfast::scene_text {
namespace {

using art::Bone;
using art::Channel;

/// Pieces of a way that no law can say, for each frame.
constexpr double pieces_per_frame = 2;
constexpr double max_pieces = 64;

enum Quantity : std::size_t { rotation, x, y, length, quantity_count };
using Quantities = std::array<Channel, quantity_count>;

std::vector<double> times_of(const Quantities& quantities)
{
    std::vector<double> times;
    for (const Channel& channel : quantities)
        for (const auto& key : with_laws(channel))
            times.push_back(key.time);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

/// One law says it; nothing if there is none that does.
std::optional<std::string> law_between(const Channel& channel, double from, double to, bool& is_one)
{
    const auto next = std::ranges::upper_bound(channel.keys, from, {}, &art::Key<double>::time);
    if (next == channel.keys.begin() || next == channel.keys.end() || channel.at(from) == channel.at(to))
        return std::nullopt;
    const auto& key = *std::prev(next);
    const double span = next->time - key.time;
    const auto parts = art::ease_parts(key.ease, (from - key.time) / span, (to - key.time) / span);
    is_one = is_one && parts.size() == 1;
    return law_of(parts.front().ease);
}

/// The law of both on a way, if one does.
std::optional<std::string> common_law(const std::optional<std::string>& one,
                                      const std::optional<std::string>& other, bool& is_one)
{
    is_one = is_one && (!one || !other || *one == *other);
    return one ? one : other;
}

class BoneWays {
public:
    explicit BoneWays(const Bone& bone)
        : quantities_{bone.rotation, bone.x, bone.y,
                      bone.length.value_or(Channel{scene::distance(bone.from, bone.to)})}
    {
    }

    std::vector<BoneKey> keys() &&
    {
        const std::vector<double> times = times_of(quantities_);
        for (std::size_t i = 0; i < times.size(); ++i)
            if (i + 1 < times.size())
                add_way(times[i], times[i + 1]);
            else
                add(times[i], {}, {});
        return std::move(keys_);
    }

private:
    void add_way(double from, double to)
    {
        bool is_one = true;
        const auto law_of_quantity = [&](Quantity quantity) {
            return law_between(quantities_[quantity], from, to, is_one);
        };
        const auto law = common_law(law_of_quantity(rotation), law_of_quantity(length), is_one);
        const auto place_law = common_law(law_of_quantity(x), law_of_quantity(y), is_one);
        if (is_one)
            return add(from, law, place_law);
        const double pieces = std::clamp(std::ceil((to - from) * pieces_per_frame), 2.0, max_pieces);
        for (double piece = 0; piece < pieces; ++piece)
            add(art::mixed(from, to, piece / pieces), "constant", "constant");
    }

    void add(double time, std::optional<std::string> law, std::optional<std::string> place_law)
    {
        keys_.push_back({time, quantities_[rotation].at(time), quantities_[x].at(time),
                         quantities_[y].at(time), quantities_[length].at(time), std::move(law),
                         std::move(place_law)});
    }

    Quantities quantities_;
    std::vector<BoneKey> keys_ = {};
};

bool is_zero(const Channel& channel) { return channel.is_still() && channel.value() == 0; }

scene::Vec2 stored(scene::Vec2 spot) { return {snapped(spot.x, coordinates), snapped(spot.y, coordinates)}; }

}

/// As the ends of a bone are rounded, it may be set up one step longer or shorter than it is.
bool changes_length(const Bone& bone)
{
    if (!bone.length)
        return false;
    const double set_up = scene::distance(stored(bone.from), stored(bone.to));
    return !bone.length->is_still() ||
           std::abs(on_grid(bone.length->value(), widths) - on_grid(set_up, widths)) > 1;
}

std::vector<BoneKey> bone_keys(const Bone& bone)
{
    if (is_zero(bone.rotation) && is_zero(bone.x) && is_zero(bone.y) && !changes_length(bone))
        return {};
    return BoneWays{bone}.keys();
}

}
