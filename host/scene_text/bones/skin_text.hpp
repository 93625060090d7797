#pragma once

#include "host/art/document/document.hpp"
#include "host/kdl/document.hpp"
#include "host/scene_text/values/writing.hpp"

namespace kfast::scene_text {

/// Adds what carries an object.
void add_skin(kdl::Node& object, const art::Skin& skin, const RigNames& names);

}
