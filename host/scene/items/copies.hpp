#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/symbol_use.hpp"
#include "host/scene/model.hpp"

namespace kfast::scene {

/// What the copies of a symbol of items are in: it has the place of the use and what changes it. `use` has
/// a count. What is wrong with the copies is reported, and what is of no use.
///
///     use dot 60 60 count=3 rotate-step=120 { key 0 rotate=0; key 9 rotate=90 }
///
///     group 60 60 { key 0 rotate=0; key 9 rotate=90     it has no place in the text
///         use dot; use dot rotate=120; use dot rotate=240 }
Group copies_of(const kdl::Node& node, const SymbolUse& use, SourceSpan place, SceneContext& context);

}
