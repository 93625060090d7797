#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/context/symbol_table.hpp"

namespace kfast::scene {

/// What `symbol` holds, before it has been read. If it only uses others, it is what the first of them is.
SymbolEntry::Kind symbol_kind(const SymbolEntry& symbol, SymbolTable& symbols);

/// Reports that `node` is of the kind that its symbol does not hold.
void report_mixed_kinds(const kdl::Node& node, SceneContext& context);

}
