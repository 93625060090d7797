#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/context/symbol_table.hpp"
#include "host/scene/items/mirror.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/schema/node_schema.hpp"

#include <optional>
#include <string_view>

namespace kfast::scene {

inline constexpr std::string_view use_name = "use";
inline constexpr std::string_view drawing_use_id = "use of drawing"; ///< among shapes (NodeSchema)

/// A node `use`, its keys apart.
struct SymbolUse {
    const SymbolEntry* symbol = nullptr;
    ItemValues values;
    Mirror mirror;
    KeyDriver driver; ///< of its keys; only of a symbol of items
};

/// A symbol of items, as an item. Nothing when there is no such symbol; what is wrong is reported.
std::optional<SymbolUse> read_items_use(const kdl::Node& node, SceneContext& context);

/// A symbol that is a drawing, inside an object; `values` has its place, rotation and scale.
std::optional<SymbolUse> read_drawing_use(const kdl::Node& node, SceneContext& context);

/// Of a use as an item, and of one among shapes.
std::vector<NodeSchema> use_words();

}
