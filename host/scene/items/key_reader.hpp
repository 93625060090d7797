#pragma once

#include "core/time/time.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/scene/values/law_reader.hpp"
#include "host/schema/node_form.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace kfast::scene {

inline constexpr std::string_view key_name = "key";
// Ids (NodeSchema) of keys that are not in objects.
inline constexpr std::string_view group_key_id = "key of group";
inline constexpr std::string_view symbol_key_id = "key of symbol";
inline constexpr std::string_view skeleton_name = "skeleton";

/// What the key is in; that decides what the key may set.
enum class KeyHolder : std::uint8_t {
    object,
    group,  ///< or a use: no drawings
    symbol, ///< of a drawing: nothing else
};

/// A key as it is written: what it sets, and how that changes until the next key that sets the same.
struct ItemKey {
    const kdl::Node* node = nullptr;
    Time time;
    SourceSpan place; ///< of its name and time
    ItemValues values;
    KeyLaws laws;
    std::optional<Match> match;
    std::optional<Drawing> drawing;
    Drawing depths = {}; ///< see Key::depths
    std::vector<SectorStroke> sectors = {};
    std::vector<std::size_t> letters = {}; ///< see Key::letters
    const kdl::Node* skeleton = nullptr;   ///< not yet read
};

/// Whether anything in `key` is a drawing, or would be one.
bool holds_drawing(const kdl::Node& key);

/// Nothing when the time of the key is unknown, which is reported like everything else. The key points to
/// `node`.
std::optional<ItemKey> read_key(const kdl::Node& node, KeyHolder holder, const KeyDriver& driver,
                                SceneContext& context);

/// The schema of keys of objects, of groups and uses, and of symbols.
std::vector<NodeSchema> key_schema();

}
