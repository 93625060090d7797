#include "core/beam/hatching_bytes.hpp"

#include "core/beam/beam_lines.hpp"

#include <algorithm>

namespace kfast {
namespace {

/// Pictures with more than this are beyond every point clock.
constexpr std::size_t max_bytes = 65536;

class HatchingCount {
public:
    explicit HatchingCount(const SceneView& scene) : scene_{scene} {}

    std::size_t bytes() { return bytes_; }

    /// Calls itself no deeper than groups and uses may lie in each other, kfb::max_depth.
    void add(ItemCursor items)
    {
        while (!items.at_end() && bytes_ < max_bytes) {
            const ItemView item = items.next();
            if (!item.is_leaf())
                add(scene_.items_in(item));
            else if (item.beam.has_hatching())
                bytes_ = std::min(bytes_ + bytes_of(item.beam), max_bytes);
        }
    }

private:
    /// Crossings and the piece between them (hatching.hpp).
    std::size_t bytes_of(const BeamStyle& style) const
    {
        constexpr std::size_t bytes_of_piece = 2 * 8 + sizeof(BeamLine);
        const int side = 16 * std::max(scene_.canvas().width, scene_.canvas().height);
        return static_cast<std::size_t>(side / style.spacing + 1) * bytes_of_piece;
    }

    const SceneView& scene_;
    std::size_t bytes_ = 0;
};

}

std::size_t hatching_bytes(const SceneView& scene)
{
    HatchingCount count{scene};
    count.add(scene.items());
    return count.bytes();
}

}
