#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kfast::link {

/// The block of memory that a board lends to its player, and the scene that a computer puts at its end:
///
///     | player, as much as it needs | free | scene that plays from RAM, or leased |
///
/// A scene lies at the end of the block, or right before the one that plays from there. All sizes are in
/// bytes; places are whole words.
class SceneMemory {
public:
    /// `block` is aligned to 4, and outlives this.
    explicit SceneMemory(std::span<std::byte> block) : block_{block} {}

    std::size_t size() const { return block_.size(); }

    /// The offset of what lies in the block; the size of the block if it lies elsewhere.
    std::size_t offset_of(std::span<const std::byte> bytes) const;

    /// Leases `size` bytes that are neither among the first `used` nor part of the scene `played`; none if
    /// there is no room.
    std::span<std::byte> lease(std::size_t size, std::size_t used, std::span<const std::byte> played);
    std::span<std::byte> leased() const { return leased_; }
    void end_lease() { leased_ = {}; }

    /// What lies before the scene `played` and before what is leased: the player's.
    std::span<std::byte> before(std::span<const std::byte> played) const;

private:
    std::optional<std::size_t> place_for(std::size_t bytes, std::size_t used,
                                         std::span<const std::byte> played) const;

    std::span<std::byte> block_;
    std::span<std::byte> leased_{};
};

}
