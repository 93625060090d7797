#include "host/art/animation/baked_spots.hpp"
#include "host/scene_text/arrange/passes.hpp"
#include "host/scene_text/values/grid.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace kfast::scene_text {
namespace {

using art::Channel;
using art::Ease;
using art::Key;

/// Cuts the way of an offset into parts of which each is within the range, without whole periods.
class Reduction {
public:
    explicit Reduction(double period) : period_{period} {}

    Channel of(const Channel& offset)
    {
        for (auto key = offset.keys.begin(); std::next(key) != offset.keys.end(); ++key)
            if (key->ease.kind == art::EaseKind::hold)
                add(key->time, key->value, key->value, key->ease);
            else
                add_way(*key, *std::next(key), 0, 1);
        const Key<double>& last = offset.keys.back();
        add(last.time, last.value, last.value, {});
        return Channel{std::move(keys_)};
    }

private:
    static double value_at(const Key<double>& key, const Key<double>& next, double share)
    {
        return art::mixed(key.value, next.value, art::share_of_way(key.ease, share));
    }

    void add_way(const Key<double>& key, const Key<double>& next, double from, double to)
    {
        const double way = std::abs(value_at(key, next, to) - value_at(key, next, from));
        const double frames = (to - from) * (next.time - key.time);
        if (way > dash_offsets.high && frames > 4 * art::Baking::jump) {
            const double middle = (from + to) / 2;
            add_way(key, next, from, middle);
            return add_way(key, next, middle, to);
        }
        for (const art::EasePart& part : art::ease_parts(key.ease, from, to))
            add(art::mixed(key.time, next.time, part.from), art::mixed(key.value, next.value, part.way_from),
                art::mixed(key.value, next.value, part.way_to), part.ease);
    }

    void add(double time, double begin, double end, const Ease& ease)
    {
        const double shift = period_ * std::round((begin + end) / (2 * period_));
        if (!keys_.empty() && end_ != begin - shift)
            jump_at(time);
        keys_.push_back({time, begin - shift, ease});
        end_ = end - shift;
    }

    /// The part before ends shortly before that.
    void jump_at(double time)
    {
        if (const double before = time - art::Baking::jump; before > keys_.back().time)
            keys_.push_back({before, end_, {}});
        keys_.back().ease = {.kind = art::EaseKind::hold};
    }

    double period_;
    double end_ = 0; ///< of the last part
    std::vector<Key<double>> keys_;
};

/// The sum of the ways from key to key.
double way_of(const Channel& channel)
{
    double way = 0;
    for (std::size_t i = 0; i + 1 < channel.keys.size(); ++i)
        way += std::abs(channel.keys[i + 1].value - channel.keys[i].value);
    return way;
}

}

void reduce_offset(art::Dashes& dashes)
{
    constexpr double max_parts = 1000;
    const double period = (dashes.lengths.size() % 2 == 0 ? 1 : 2) * period_at(dashes, 0);
    const auto is_within = [](const auto& key) { return std::abs(key.value) <= dash_offsets.high; };
    if (std::ranges::all_of(dashes.offset.keys, is_within) || !has_still_lengths(dashes) || period == 0 ||
        way_of(dashes.offset) > max_parts * dash_offsets.high)
        return;
    dashes.offset = Reduction{period}.of(dashes.offset);
}

}
