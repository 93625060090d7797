#include "host/scene_text/stored_keys.hpp"

namespace kfast::scene_text {

void part_ticks(std::vector<std::int32_t>& ticks, std::int32_t length)
{
    for (std::size_t i = 1; i < ticks.size(); ++i)
        ticks[i] = std::max(ticks[i], ticks[i - 1] + 1);
    std::int32_t latest = length;
    for (auto tick = ticks.rbegin(); tick != ticks.rend(); ++tick) {
        *tick = std::min(*tick, latest);
        latest = *tick - 1;
    }
}

std::vector<StoredKey<std::int32_t>> stored_keys(const art::Channel& channel, std::int32_t length,
                                                 const Grid& grid)
{
    return stored_keys(channel, length, [&](double value) { return on_grid(value, grid); });
}

}
