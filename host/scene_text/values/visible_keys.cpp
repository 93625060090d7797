#include "host/scene_text/values/visible_keys.hpp"

namespace kfast::scene_text {
namespace {

/// Of a moment that may lie outside of the scene, or be infinite.
std::int32_t ticks_within(double time, std::int32_t length) { return std::min(on_grid(time, times), length); }

}

std::vector<StoredKey<bool>> visible_keys(const std::vector<art::Span>& shown, std::int32_t length)
{
    std::vector<StoredKey<bool>> keys{{0, false}};
    for (const art::Span& span : shown) {
        const std::int32_t from = ticks_within(span.from, length);
        const std::int32_t to = ticks_within(span.to, length);
        if (from >= to)
            continue;
        if (keys.back().ticks == from)
            keys.pop_back();
        if (keys.empty() || !keys.back().value)
            keys.push_back({from, true});
        if (to < length)
            keys.push_back({to, false});
    }
    return keys;
}

}
