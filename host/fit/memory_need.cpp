#include "host/fit/memory_need.hpp"

#include <algorithm>
#include <numeric>

namespace kfast::fit {
namespace {

/// By the compiler's figures for the deepest scene: docs/design.md, "The bound on memory".
constexpr std::size_t stack_bound = 9216;

std::size_t sum_of(const std::vector<Reserved>& parts, std::size_t Reserved::*bytes)
{
    return std::accumulate(parts.begin(), parts.end(), std::size_t{},
                           [bytes](std::size_t sum, const Reserved& part) { return sum + part.*bytes; });
}

}

std::size_t Target::reserved_flash() const { return sum_of(reserved, &Reserved::flash); }

std::size_t Target::reserved_ram() const { return sum_of(reserved, &Reserved::ram); }

FlashNeed flash_need(const SceneView& scene, const Target& target)
{
    return {costs_of(target.processor).code, scene.size(), target.reserved_flash()};
}

RamNeed ram_need(const SceneView& scene, const Target& target)
{
    const ProcessorCosts& costs = costs_of(target.processor);
    return {Player::block_bytes(scene, target.display.size), 2 * target.band_bytes, costs.fixed_ram,
            std::max(costs.stack, stack_bound), target.reserved_ram()};
}

std::size_t least_band(const Display& display)
{
    return row_bytes(display.format, display.size.width) *
           static_cast<std::size_t>(display.granularity.height);
}

}
