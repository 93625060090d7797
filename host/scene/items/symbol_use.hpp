#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/context/tables.hpp"
#include "host/scene/items/key_reader.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/scene/values/own_time.hpp"
#include "host/scene/values/repeat.hpp"
#include "host/scene/values/timed_quantity.hpp"
#include "host/schema/node_form.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace kfast::scene {

/// Which scales of a use change their sign: x exchanges left and right.
struct Mirror {
    bool x = false;
    bool y = false;
};

/// Mirrors an item and what its keys and tracks set.
inline void mirror(const Mirror& axes, ItemValues& item, std::span<ItemKey> keys,
                   std::span<TimedQuantity> timed)
{
    const auto mirror_axis = [&](Property scale) {
        item[scale] = -item.get(scale).value_or(scale_one);
        for (ItemKey& key : keys)
            if (const auto own = key.values.get(scale))
                key.values[scale] = -*own;
        if (Track* const track = find_track(timed, scale))
            for (TrackKey& key : track->keys)
                key.value = -key.value;
    };
    if (axes.x)
        mirror_axis(Property::scale_x);
    if (axes.y)
        mirror_axis(Property::scale_y);
}

inline constexpr std::string_view use_name = "use";
inline constexpr std::string_view drawing_use_id = "use of drawing"; ///< among shapes (NodeSchema)

/// A node `use` without its keys.
struct SymbolUse {
    const SymbolEntry* symbol = nullptr;
    ItemValues values;
    Mirror mirror;
    KeyDriver driver; ///< of its keys; only of a symbol of items
    UseTime time = {};
    Repeat repeat = {};
    Driver inner = {}; ///< what the keys of the symbol go by, see own_driver()
};

/// A symbol of items, as an item. Nothing when there is no such symbol; what is wrong is reported.
std::optional<SymbolUse> read_items_use(const kdl::Node& node, SceneContext& context);

/// A symbol that is a drawing, inside an object; `values` has its position, rotation and scale.
std::optional<SymbolUse> read_drawing_use(const kdl::Node& node, SceneContext& context);

/// The schema of a use as an item, and of one among shapes.
std::vector<NodeSchema> use_schema();

/// What `symbol` holds, before it has been read. If it only uses others, it is what the first of them is.
SymbolEntry::Kind symbol_kind(const SymbolEntry& symbol, SymbolTable& symbols);

/// Reports `node`, which is of the kind that its symbol does not hold.
void report_mixed_kinds(const kdl::Node& node, SceneContext& context);

}
