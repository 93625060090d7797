#pragma once

#include "host/synfig/reading/layer.hpp"

#include <optional>

namespace kfast::synfig {

bool is_group(const Layer& layer);

/// What a group does to its content.
art::Transform placement_of(const Layer& group);

/// What is inside of a group, where it stands.
Scope inside_of(const Layer& group);

/// Of a layer that moves, turns or stretches all that lies below it. Nothing for layers of other types.
std::optional<art::Transform> movement_of(const Layer& layer);

/// Of a layer that changes the time of all that lies below it, likewise.
std::optional<Driver::Gear> gear_of(const Layer& layer);

/// When a switch shows a layer with that name, which is the one at that depth, from 0 at the top.
std::vector<art::Span> shown_by_switch(const Layer& choice, const std::string& name, std::size_t depth);

}
