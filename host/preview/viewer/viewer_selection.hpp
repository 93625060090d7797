#pragma once

#include "host/preview/playback/time_table.hpp"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace kfast {

/// Identifies an item in a scene that was read again: several may have one name.
struct ItemName {
    std::string name;           ///< as on the time line
    std::size_t occurrence = 0; ///< among the rows of that name
};

/// The name of the item of that number in SceneFile::item_names; none if there is none.
std::optional<ItemName> name_of(std::optional<std::size_t> item, const TimeTable& table);
/// The number of the item of that name; none if there is none.
std::optional<std::size_t> item_of(const ItemName& name, const TimeTable& table);
/// The names of several items, without those that do not exist.
std::vector<ItemName> names_of(const std::set<std::size_t>& items, const TimeTable& table);
std::set<std::size_t> items_of(const std::vector<ItemName>& names, const TimeTable& table);
/// The item `rows` rows further down; past either end there is none, and after that the other end.
std::optional<std::size_t> item_beside(std::optional<std::size_t> item, std::ptrdiff_t rows,
                                       const TimeTable& table);

}
