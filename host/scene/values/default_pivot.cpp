#include "host/scene/values/default_pivot.hpp"

#include <algorithm>
#include <limits>

namespace kfast::scene {
namespace {

class Extent {
public:
    void add(int value)
    {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
    std::int16_t centre() const { return static_cast<std::int16_t>((low_ + high_ + 1) >> 1); }

private:
    int low_ = std::numeric_limits<int>::max();
    int high_ = std::numeric_limits<int>::min();
};

struct Centre {
    Extent x;
    Extent y;

    void add(Point point)
    {
        x.add(point.x);
        y.add(point.y);
    }
};

Centre centre_of(const Drawing& drawing)
{
    Centre centre;
    for (const Stroke& stroke : drawing.strokes) {
        centre.add(stroke.from);
        for (const Segment& segment : stroke.segments)
            centre.add(segment.to);
    }
    return centre;
}

}

void set_default_pivot(const std::vector<Key>& keys, ItemValues& values)
{
    const auto is_seen = [](const Key& key) { return !key.drawing.strokes.empty(); };
    const auto first = std::ranges::find_if(keys, is_seen);
    if (first == keys.end())
        return;
    const Centre centre = centre_of(first->drawing);
    set_default_pivot({centre.x.centre(), centre.y.centre()}, values);
}

void set_default_pivot(Point pivot, ItemValues& values)
{
    auto& x = values[Property::pivot_x];
    auto& y = values[Property::pivot_y];
    x = x.value_or(pivot.x);
    y = y.value_or(pivot.y);
}

}
