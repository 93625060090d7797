#include "host/art/animation/clamped_channel.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace kfast::art {
namespace {

class Clamping {
public:
    Clamping(double low, double high) : low_{low}, high_{high} {}

    Channel of(const Channel& channel)
    {
        for (std::size_t i = 0; i + 1 < channel.keys.size(); ++i)
            add_way(channel.keys[i], channel.keys[i + 1]);
        const Key<double>& last = channel.keys.back();
        keys_.push_back({last.time, held(last.value), last.ease});
        return Channel{std::move(keys_)};
    }

private:
    double held(double value) const { return std::clamp(value, low_, high_); }

    void add_way(const Key<double>& key, const Key<double>& next)
    {
        const bool is_within = held(key.value) == key.value && held(next.value) == next.value;
        if (is_within || key.ease.kind == EaseKind::hold) {
            keys_.push_back({key.time, held(key.value), key.ease});
            return;
        }
        const std::vector<double> shares = crossings(key, next);
        for (std::size_t i = 0; i + 1 < shares.size(); ++i)
            add_part(key, next, shares[i], shares[i + 1]);
    }

    static double value_at(const Key<double>& key, const Key<double>& next, double share)
    {
        return mixed(key.value, next.value, share_of_way(key.ease, share));
    }

    /// The shares of the time at which the value passes one of the limits, with 0 and 1.
    std::vector<double> crossings(const Key<double>& key, const Key<double>& next) const
    {
        constexpr int looks = 16; // an ease turns back at most twice
        std::vector<double> shares{0, 1};
        for (int i = 0; i < looks; ++i)
            for (const double limit : {low_, high_}) {
                const double from = i / double{looks};
                const double to = (i + 1) / double{looks};
                const auto is_above = [&](double share) { return value_at(key, next, share) > limit; };
                if (is_above(from) != is_above(to))
                    shares.push_back(change_of(is_above, from, to));
            }
        std::ranges::sort(shares);
        shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
        return shares;
    }

    template <typename IsAbove>
    static double change_of(const IsAbove& is_above, double from, double to)
    {
        constexpr int halvings = 40;
        const bool before = is_above(from);
        for (int i = 0; i < halvings; ++i) {
            const double middle = (from + to) / 2;
            (is_above(middle) == before ? from : to) = middle;
        }
        return to;
    }

    void add_part(const Key<double>& key, const Key<double>& next, double from, double to)
    {
        const auto add = [&](double share, double value, const Ease& ease) {
            const double time = mixed(key.time, next.time, share);
            if (keys_.empty() || time > keys_.back().time)
                keys_.push_back({time, held(value), ease});
        };
        const double middle = value_at(key, next, (from + to) / 2);
        if (held(middle) != middle)
            return add(from, middle, {});
        for (const EasePart& part : ease_parts(key.ease, from, to))
            add(part.from, mixed(key.value, next.value, part.way_from), part.ease);
    }

    double low_;
    double high_;
    std::vector<Key<double>> keys_;
};

}

Channel clamped(const Channel& channel, double low, double high) { return Clamping{low, high}.of(channel); }

}
