#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/model.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace kfast::scene {

/// An input that has been read.
struct InputEntry {
    Input input;
    SourceSpan place;
    bool is_used = false;       ///< keys go by it
    bool is_range_known = true; ///< else it was invalid
};

/// The inputs of a scene in their order.
struct InputTable {
    std::vector<InputEntry> entries = {};

    InputEntry* find(std::string_view name)
    {
        for (InputEntry& entry : entries)
            if (entry.input.name == name)
                return &entry;
        return nullptr;
    }
};

/// A skeleton that has been read.
struct Skeleton {
    Bones bones;
    std::vector<double> regions; ///< how far each bone reaches to either side, in pixels
    bool is_valid = true;        ///< if not, what is wrong has been reported, and bones may be missing
    bool is_used = false;
};

std::optional<std::size_t> find_bone(const std::vector<Bone>& bones, std::string_view name);
std::vector<std::string_view> names_of(const std::vector<Bone>& bones);

/// The skeletons of a scene, in the order in which they are stored.
struct SkeletonTable {
    std::optional<std::size_t> find(std::string_view name) const;
    std::vector<std::string_view> names() const;
    /// Of all skeletons together.
    std::size_t bone_count() const;

    std::vector<Skeleton> entries;
};

/// The content of a symbol, and how far it has been read.
struct SymbolEntry {
    enum class Kind : std::uint8_t { items, drawing };
    enum class State : std::uint8_t { unread, in_progress, good, bad };

    const kdl::Node* node = nullptr;
    std::string name;
    SourceSpan place; ///< of the name
    State state = State::unread;
    bool is_used = false;
    std::optional<Kind> kind;
    int depth = 0;                  ///< how deeply groups and uses in it are nested
    std::optional<Time> length;     ///< of its own time, if it gives one
    std::optional<Loop> loop;       ///< likewise
    Time last_key;                  ///< the end of its keys, and of one pass of what it uses
    bool is_retimed = false;        ///< a use of it, or of what it is in, has a time of its own
    std::vector<std::size_t> users; ///< the numbers of the symbols that use it
    /// Of keys that the scene ends before, if it goes by the scene's time; "key" or "value", and where.
    std::vector<std::pair<std::string, SourceSpan>> late_keys;

    std::vector<Item> items; ///< a Use in it has the number of the entry
    std::vector<Key> keys;   ///< of a drawing: at least one
    /// For a drawing without keys: the outlines of its only key, before rounding.
    std::optional<std::vector<Outline>> still;
    std::string line_font; ///< font of a text in the drawing whose letters are lines; empty: there is none

    /// In Scene::symbols, for each driver that its keys go by somewhere, and steps of its colours.
    std::map<std::pair<Driver, int>, std::size_t> scene_indices;
};

/// The symbols of a scene. All are added before any is looked up.
class SymbolTable {
public:
    /// Returns the location of an earlier symbol of that name, if there is one; then nothing is changed.
    std::optional<SourceSpan> add(const SymbolEntry& entry);
    /// Null when there is no such symbol.
    SymbolEntry* find(std::string_view name);
    /// Of an entry of this table.
    std::size_t number(const SymbolEntry& entry) const
    {
        return static_cast<std::size_t>(&entry - entries.data());
    }
    std::vector<std::string_view> names() const;

    std::vector<SymbolEntry> entries;
    std::vector<const SymbolEntry*> in_progress; ///< each uses the next
    bool has_long_chain = false;                 ///< of symbols; has been reported

private:
    std::unordered_map<std::string, std::size_t> numbers_;
};

}
