#pragma once

#include "core/time/time.hpp"
#include "host/preview/playback/playback_setup.hpp"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast {

/// One item of the scene on the time line.
struct TimeRow {
    std::size_t item = 0;   ///< its number in SceneFile::item_names
    std::string name;       ///< as in the scene; of an item without a name "object 3", "group"
    int depth = 0;          ///< groups and uses around it
    std::vector<Time> keys; ///< of its drawings and tracks, and of the bones and backbones that deform it
    /// Those of its quantities that have such keys, by name.
    std::vector<std::pair<std::string, std::vector<Time>>> quantities = {};
    bool is_unfolded = false; ///< rows of its quantities follow
    bool is_quantity = false; ///< `name` is that of a quantity of the item, and `keys` are its

    bool can_unfold() const { return !quantities.empty(); }
};

/// What happens when: rows from the top item down, clips and events.
struct TimeTable {
    struct Event {
        Time time;
        std::string name;
    };
    Time end;
    std::vector<TimeRow> rows = {};
    std::vector<Part> clips = {};
    std::vector<Event> events = {};

    /// Null if there is none, as when nothing is selected.
    const TimeRow* row_of(std::optional<std::size_t> item) const;
    /// The topmost row of that name, or null.
    const TimeRow* row_named(std::string_view name) const;
    /// The keys of an item and of what is in it: in order, each time once. Empty if it has no row.
    std::vector<Time> keys_of(std::size_t item) const;
};

/// Adds a row for each quantity below those of `unfolded`, which are TimeRow::item.
TimeTable with_quantities(const TimeTable& table, const std::set<std::size_t>& unfolded);

/// The contents of a symbol follow the topmost use of it. Keys that go by an input are left out.
TimeTable time_table(const SceneView& scene, const std::vector<std::string>& item_names);

}
