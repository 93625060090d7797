#pragma once

#include "core/pose/posed_backbones.hpp"
#include "host/scene/model.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast {

/// The drawing that represents a skeleton: for each backbone its nodes, its left and its right outline.
scene::Drawing drawing_of(const std::vector<scene::Backbone>& backbones);

/// The backbones of an object at any time, exactly as the player has them.
class BackboneTimeline {
public:
    /// `keys` has a key at least and must outlive this.
    explicit BackboneTimeline(const std::vector<scene::BackboneKey>& keys);

    std::vector<Time> key_times() const;
    std::size_t node_count() const;
    /// `nodes` has room for node_count() and must outlive the result.
    PosedBackbones at(Time time, std::uint32_t unit_bits, std::span<BackboneNode> nodes) const;
    std::vector<BackboneNode> nodes_at(Time time) const;

private:
    PackedDrawing drawing(std::size_t index) const;

    const std::vector<scene::BackboneKey>& keys_;
    std::vector<std::vector<std::byte>> drawings_; ///< packed, one for each key
};

}
