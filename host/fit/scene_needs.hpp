#pragma once

#include "core/player.hpp"
#include "core/scene/scene_view.hpp"
#include "host/fit/cost_table.hpp"
#include "host/fit/target.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace kfast::fit {

constexpr std::size_t room_beside(std::size_t firmware, std::size_t available)
{
    return available > firmware ? available - firmware : 0;
}

/// Bytes of flash that a scene takes on a board.
struct FlashNeed {
    std::size_t player = 0;
    std::size_t scene = 0;
    std::size_t reserved = 0;
    std::optional<FeatureSet> features{}; ///< all that the player has; none: every one

    std::size_t sum() const { return player + scene + reserved; }
    /// The room for scenes, next to the firmware.
    std::size_t room(std::size_t available) const { return room_beside(player + reserved, available); }
};

/// Bytes of RAM: enough for every time of the scene.
struct RamNeed {
    std::size_t block = 0;
    std::size_t bands = 0;
    std::size_t fixed = 0;
    std::size_t stack = 0;
    std::size_t reserved = 0;

    std::size_t sum() const { return block + bands + fixed + stack + reserved; }
    /// The room for the blocks of scenes, next to the firmware.
    std::size_t room(std::size_t available) const { return room_beside(sum() - block, available); }
};

/// Code and constants of a player with these features and no others; no less than in fact.
std::size_t player_code(FeatureSet features, Processor processor);

FlashNeed flash_need(const SceneView& scene, const Target& target);
RamNeed ram_need(const SceneView& scene, const Target& target);
/// The size of one of the bands: a row of the panel, or as many as it takes together.
std::size_t min_band(const Display& display);

/// The maximum number of reports of 64 bytes that a device takes by USB (boards/pico/README.md, "USB").
inline constexpr double reports_per_second = 1000;

/// What setting inputs of a scene takes on the link (docs/link.md).
struct LinkUpdate {
    std::string what;        ///< "13 numbers", "plot, 200 points in 1 stroke"
    std::size_t reports = 0; ///< for all of it

    double max_per_second() const { return reports_per_second / static_cast<double>(reports); }
};

/// All numbers at once, if the scene has some, and each drawing with all of its points.
std::vector<LinkUpdate> link_need(const SceneView& scene);

}
