#pragma once

#include <cstddef>
#include <cstdint>

namespace kfast {

/// How much more SceneView::parse() reads: keys and points of drawings. A scene says in few bytes that many
/// keys have the same drawing, or that many tracks have the same key times, and whoever parses it reads them
/// for each; so a bound on the bytes alone would be none on the time.
class ReadAllowance {
public:
    explicit constexpr ReadAllowance(std::size_t scene_bytes)
        : left_{for_any_scene + per_byte * static_cast<std::uint32_t>(scene_bytes)}
    {
    }

    /// Whether so much may be read; then it counts as read.
    constexpr bool take(std::uint32_t keys_or_points)
    {
        if (keys_or_points > left_)
            return false;
        left_ -= keys_or_points;
        return true;
    }

private:
    static constexpr std::uint32_t for_any_scene = 1U << 18;
    static constexpr std::uint32_t per_byte = 2; ///< drawings and keys as the compiler writes them take less

    std::uint32_t left_;
};

}
