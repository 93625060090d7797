#include "core/time/track.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::int32_t largest = 1 << 20;
constexpr std::int32_t farthest = 1 << 30;

class KeySampleCursor {
public:
    explicit KeySampleCursor(std::span<const KeySample> keys) : keys_{keys} {}

    bool at_end() const { return keys_.empty(); }

    KeySample next()
    {
        const KeySample key = keys_.front();
        keys_ = keys_.subspan(1);
        return key;
    }

private:
    std::span<const KeySample> keys_;
};

bool is_within(std::int32_t value, std::int32_t limit) { return value >= -limit && value <= limit; }

}

bool Track::add(Time time, std::int32_t value)
{
    if (!is_within(value, largest) || !is_within(time.ticks, farthest - 1))
        return false;
    const auto keys = storage_.first(count_);
    const auto place = std::ranges::lower_bound(keys, time, {}, &KeySample::time);
    if (place != keys.end() && place->time == time) {
        place->value = value;
        return true;
    }
    if (count_ == storage_.size())
        return false;
    const auto index = place - keys.begin();
    ++count_;
    const auto grown = storage_.first(count_);
    std::move_backward(grown.begin() + index, grown.end() - 1, grown.end());
    grown[static_cast<std::size_t>(index)] = {time, value};
    return true;
}

std::int32_t Track::value_at(Time time) const
{
    if (count_ == 0)
        return 0;
    return hermite(hermite_span_at(KeySampleCursor{keys()}, time), time);
}

}
