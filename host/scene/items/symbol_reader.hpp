#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/context/tables.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"

#include <string_view>

namespace kfast::scene {

inline constexpr std::string_view symbol_name = "symbol";

/// Enters a symbol in `context.symbols`, unread.
void add_symbol(const kdl::Node& node, SceneContext& context);

/// The symbol that `name` names, read. Null when it cannot be used: there is none, it is invalid, or it is
/// just being read and so uses itself. What is wrong is reported.
const SymbolEntry* find_symbol(const kdl::Value& name, SceneContext& context);

/// Reads the symbols that have not been used, for their mistakes, and warns of them.
void check_unused_symbols(SceneContext& context);

/// Warns of keys in symbols that go by the scene's time wherever they are used, and are later than its end.
/// All uses have been read.
void warn_of_late_keys(SceneContext& context);

/// The schema of symbols of items, and of those that are drawings.
std::vector<NodeSchema> symbol_schema();

}
