#pragma once

#include "host/synfig/reading/layer.hpp"

#include <optional>

namespace kfast::synfig {

bool is_group(const Layer& layer);

/// What a group does to its content.
art::Transform placement_of(const Layer& group);

/// The scope inside of a group.
Scope inside_of(const Layer& group);

/// The transform of a layer that moves, rotates or stretches all that is below it. Nothing for other types.
std::optional<art::Transform> movement_of(const Layer& layer);

/// The gear of a layer that changes the time of all that is below it. Nothing for other types.
std::optional<Driver::Gear> gear_of(const Layer& layer);

/// When a switch shows the layer with that name, which is at that depth, from 0 at the top.
std::vector<art::Span> shown_by_switch(const Layer& choice, const std::string& name, std::size_t depth);

}
