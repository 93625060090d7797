#pragma once

#include "host/art/animation/animated.hpp"
#include "host/art/budget.hpp"
#include "host/art/geometry/drawing.hpp"

#include <functional>
#include <map>
#include <vector>

namespace kfast::lottie {

/// When something starts to change differently, and how the properties that it comes from go on from there.
struct Moment {
    std::vector<art::Ease> eases; ///< different ones
    bool jump = false;            ///< something changes abruptly
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

/// A drawing as a function of time, exact at every moment; what it is made of can be put together without
/// a loss, and keys are found once, at the end.
struct MovingDrawing {
    std::function<art::Drawing(double)> at;
    Moments moments;           ///< between them it changes smoothly; none: it never changes
    bool changes_form = false; ///< the numbers of its outlines and curves may change at any time
    double points = 1;         ///< that it has at most
    double cost = 1;           ///< of evaluating it once, in points that are computed
};

MovingDrawing moving(art::Animated<art::Drawing> drawing);

/// The outlines of all, in their order. There is at least one drawing.
MovingDrawing together(std::vector<MovingDrawing> drawings);

/// How far baked keys may be from what they represent, in pixels.
inline constexpr double baked_tolerance = 1.0 / 32;

/// Where the change between two moments follows one ease, it is kept; elsewhere there are as many keys as
/// baked_tolerance needs. Where the form changes, the drawing jumps from one form to the other.
art::Animated<art::Drawing> keys_of(const MovingDrawing& drawing, art::Budget& budget);

}
