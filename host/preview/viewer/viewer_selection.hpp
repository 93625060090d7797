#pragma once

#include "host/preview/playback/time_table.hpp"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace kfast {

/// An item as it is known in a scene that was read again: several may have one name.
struct ItemName {
    std::string name;           ///< as on the time line
    std::size_t occurrence = 0; ///< among the rows of that name
};

/// Of the item at that place of SceneFile::item_names; nothing if there is none.
std::optional<ItemName> name_of(std::optional<std::size_t> item, const TimeTable& table);
/// The other way round.
std::optional<std::size_t> item_of(const ItemName& name, const TimeTable& table);
/// Those of several, without those that there are not.
std::vector<ItemName> names_of(const std::set<std::size_t>& items, const TimeTable& table);
std::set<std::size_t> items_of(const std::vector<ItemName>& names, const TimeTable& table);
/// So many rows further down; past either end there is none, and behind that the other end.
std::optional<std::size_t> item_beside(std::optional<std::size_t> item, std::ptrdiff_t rows,
                                       const TimeTable& table);

}
