#pragma once

#include "host/art/document/document.hpp"
#include "host/kdl/document.hpp"
#include "host/scene_text/values/reach.hpp"
#include "host/scene_text/values/writing.hpp"

#include <vector>

namespace kfast::scene_text {

/// Gives skeletons and their bones names.
std::vector<RigNames> rig_names(const std::vector<art::Rig>& rigs);

/// A node `bones` for each of the skeletons that deform something in the document's nodes. Adds their
/// coordinates to `reach`; what is out of the range of scenes is clamped, which is a loss.
std::vector<kdl::Node> rig_nodes(const art::Document& document, const Writing& writing, Reach& reach);

/// Adds what deforms an object.
void add_skin(kdl::Node& object, const art::Skin& skin, const RigNames& names);

}
