#pragma once

#include "host/art/animation/animated.hpp"

#include <map>
#include <vector>

namespace kfast::lottie {

/// When something begins another way, and how the properties that it comes from go on from there.
struct Moment {
    std::vector<art::Ease> eases; ///< different ones
    bool jump = false;            ///< something is another at once
};

/// The times of all keys that something comes from. None if it never changes.
class Moments {
public:
    template <typename Value>
    void add(const art::Animated<Value>& animated)
    {
        if (animated.is_still())
            return;
        for (std::size_t i = 0; i < animated.keys.size(); ++i) {
            Moment& moment = list_[animated.keys[i].time];
            if (i + 1 < animated.keys.size())
                add(moment, animated.keys[i].ease);
            if (i > 0 && animated.keys[i - 1].ease.kind == art::EaseKind::hold)
                moment.jump = true;
        }
    }
    void add(const Moments& others);

    bool empty() const { return list_.empty(); }
    const std::map<double, Moment>& list() const { return list_; }

private:
    static void add(Moment& moment, const art::Ease& ease);

    std::map<double, Moment> list_;
};

}
