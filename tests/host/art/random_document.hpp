#pragma once

#include "host/art/animation/ease.hpp"
#include "host/art/document/document.hpp"

#include <algorithm>
#include <random>

namespace kfast::test {

/// Art of any kind, always the same for a seed.
class RandomArt {
public:
    explicit RandomArt(unsigned seed) : engine_{seed} {}

    double number(double low, double high)
    {
        return std::uniform_real_distribution<double>{low, high}(engine_);
    }
    int integer(int low, int high) { return std::uniform_int_distribution<int>{low, high}(engine_); }
    bool chance(double share) { return number(0, 1) < share; }
    scene::Vec2 spot(double reach) { return {number(-reach, reach), number(-reach, reach)}; }

    art::Ease ease()
    {
        switch (integer(0, 3)) {
        case 0:
            return {};
        case 1:
            return {art::EaseKind::hold};
        case 2:
            return {art::EaseKind::cubic, number(0, 1), number(0, 1), number(0, 1), number(0, 1)};
        default:
            return {art::EaseKind::cubic, number(0, 1), number(-1, 2), number(0, 1), number(-1, 2)};
        }
    }

    /// Rising and at least 1/16 apart.
    std::vector<double> times(double from, double to)
    {
        std::vector<double> list;
        for (double time = number(from, to); time < to; time += number(0.0625, (to - from) / 2))
            list.push_back(time);
        return list;
    }

    art::Channel channel(double from, double to, double reach)
    {
        std::vector<art::Key<double>> keys;
        for (const double time : times(from, to))
            keys.push_back({time, number(-reach, reach), ease()});
        return keys.empty() ? art::Channel{number(-reach, reach)} : art::Channel{std::move(keys)};
    }

    /// The channel with keys added, which change nothing but for some noise.
    art::Channel crowded(const art::Channel& channel, double noise)
    {
        std::vector<art::Key<double>> keys;
        for (std::size_t i = 0; i + 1 < channel.keys.size(); ++i) {
            const auto& key = channel.keys[i];
            const auto& next = channel.keys[i + 1];
            const double middle = number(0.1, 0.9);
            for (const auto& range : {std::pair{0.0, middle}, std::pair{middle, 1.0}})
                for (const auto& part : art::ease_parts(key.ease, range.first, range.second))
                    keys.push_back({key.time + part.from * (next.time - key.time),
                                    art::mixed(key.value, next.value, part.way_from) + number(-noise, noise),
                                    part.ease});
        }
        keys.push_back(channel.keys.back());
        return art::Channel{std::move(keys)};
    }

private:
    std::mt19937 engine_;
};

}
