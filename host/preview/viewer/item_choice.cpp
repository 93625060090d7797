#include "host/preview/viewer/item_choice.hpp"

#include <algorithm>

namespace kfast {

std::optional<ItemName> name_of(std::optional<std::size_t> item, const TimeTable& table)
{
    const auto row = std::ranges::find(table.rows, item, &TimeRow::item);
    if (row == table.rows.end())
        return std::nullopt;
    const auto before =
        std::count_if(table.rows.begin(), row, [&](const TimeRow& other) { return other.name == row->name; });
    return ItemName{row->name, static_cast<std::size_t>(before)};
}

std::optional<std::size_t> item_of(const ItemName& name, const TimeTable& table)
{
    std::size_t before = 0;
    for (const TimeRow& row : table.rows)
        if (row.name == name.name && before++ == name.occurrence)
            return row.item;
    return std::nullopt;
}

std::vector<ItemName> names_of(const std::set<std::size_t>& items, const TimeTable& table)
{
    std::vector<ItemName> names;
    for (const std::size_t item : items)
        if (const auto name = name_of(item, table))
            names.push_back(*name);
    return names;
}

std::set<std::size_t> items_of(const std::vector<ItemName>& names, const TimeTable& table)
{
    std::set<std::size_t> items;
    for (const ItemName& name : names)
        if (const auto item = item_of(name, table))
            items.insert(*item);
    return items;
}

std::optional<std::size_t> item_beside(std::optional<std::size_t> item, std::ptrdiff_t rows,
                                       const TimeTable& table)
{
    const auto count = static_cast<std::ptrdiff_t>(table.rows.size());
    const auto here = std::ranges::find(table.rows, item, &TimeRow::item) - table.rows.begin();
    const std::ptrdiff_t next = (here + rows + count + 1) % (count + 1);
    if (next == count)
        return std::nullopt;
    return table.rows[static_cast<std::size_t>(next)].item;
}

}
