#include "host/preview/playback/time_table.hpp"

#include "host/preview/playback/item_facts.hpp"
#include "host/walk/every_item.hpp"
#include "host/walk/key_times.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace kfast {
namespace {

/// Makes the rows of items, the topmost first.
class TimeRows {
public:
    TimeRows(const SceneView& scene, const std::vector<std::string>& names)
        : scene_{scene}, items_{stored_items(scene, names)}
    {
        add(scene.items(), 0);
    }

    std::vector<TimeRow> take() { return std::move(rows_); }

private:
    void add(ItemCursor items, int depth)
    {
        std::vector<ItemView> upwards;
        while (!items.at_end())
            upwards.push_back(items.next());
        for (auto item = upwards.rbegin(); item != upwards.rend(); ++item)
            add(*item, depth);
    }

    void add(const ItemView& item, int depth)
    {
        const StoredItem& stored = items_.at(item.place);
        rows_.push_back({stored.number, stored.name.empty() ? name_of(item) : stored.name, depth,
                         key_times(scene_, item), timed_quantities(item)});
        const bool is_listed = item.kind == ItemKind::use && !symbols_.insert(item.symbol).second;
        if (!item.is_leaf() && !is_listed)
            add(scene_.items_in(item), depth + 1);
    }

    std::vector<std::pair<std::string, std::vector<Time>>> timed_quantities(const ItemView& item) const
    {
        std::vector<std::pair<std::string, std::vector<Time>>> timed;
        for (const Quantity& quantity : quantities_of(scene_, item)) {
            if (!quantity.driver.is_time())
                continue;
            auto& keys = timed.emplace_back(quantity.name, std::vector<Time>{}).second;
            for (const QuantityKey& key : quantity.keys)
                keys.push_back(key.time);
        }
        return timed;
    }

    static std::string name_of(const ItemView& item)
    {
        return item.kind == ItemKind::group ? "group" : "use of symbol " + std::to_string(item.symbol + 1);
    }

    const SceneView& scene_;
    std::map<const std::byte*, StoredItem> items_;
    std::set<std::uint32_t> symbols_; ///< whose items are listed
    std::vector<TimeRow> rows_;
};

}

const TimeRow* TimeTable::row_of(std::optional<std::size_t> item) const
{
    const auto row = std::ranges::find(rows, item, &TimeRow::item);
    return row == rows.end() ? nullptr : &*row;
}

const TimeRow* TimeTable::row_named(std::string_view name) const
{
    const auto row = std::ranges::find(rows, name, &TimeRow::name);
    return row == rows.end() ? nullptr : &*row;
}

std::vector<Time> TimeTable::keys_of(std::size_t item) const
{
    auto row = std::ranges::find(rows, item, &TimeRow::item);
    if (row == rows.end())
        return {};
    std::set<Time> keys{row->keys.begin(), row->keys.end()};
    const int depth = row->depth;
    for (++row; row != rows.end() && row->depth > depth; ++row)
        keys.insert(row->keys.begin(), row->keys.end());
    return {keys.begin(), keys.end()};
}

TimeTable with_quantities(const TimeTable& table, const std::set<std::size_t>& unfolded)
{
    TimeTable whole{.end = table.end, .clips = table.clips, .events = table.events};
    for (const TimeRow& row : table.rows) {
        whole.rows.push_back(row);
        if (!row.can_unfold() || !unfolded.contains(row.item))
            continue;
        whole.rows.back().is_unfolded = true;
        for (const auto& [name, keys] : row.quantities)
            whole.rows.push_back(
                {.item = row.item, .name = name, .depth = row.depth + 1, .keys = keys, .is_quantity = true});
    }
    return whole;
}

TimeTable time_table(const SceneView& scene, const std::vector<std::string>& item_names)
{
    TimeTable table{.end = scene.length(), .rows = TimeRows{scene, item_names}.take()};
    for (ClipCursor clips = scene.clips(); !clips.at_end();) {
        const ClipView clip = clips.next();
        table.clips.push_back({std::string{clip.name}, play_range_of(clip)});
    }
    for (EventCursor events = scene.events(); !events.at_end();) {
        const EventView event = events.next();
        table.events.push_back({event.time, std::string{event.name}});
    }
    return table;
}

}
