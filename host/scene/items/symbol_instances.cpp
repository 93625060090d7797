#include "host/scene/items/symbol_instances.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/context/tables.hpp"
#include "host/scene/values/own_time.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <variant>

namespace kfast::scene {
namespace {

/// What is around an item that it takes over.
struct Around {
    Driver driver;   ///< of keys that name none
    int colours = 0; ///< the steps of its colours along the palette
};

/// Clocks are those of SceneContext::clocks until driver_in() makes them the scene's.
class SymbolInstances {
public:
    SymbolInstances(Scene& scene, SceneContext& context) : scene_{scene}, context_{context} {}

    /// Depth first, so that each symbol comes after those that it uses.
    void resolve(std::vector<Item>& items, const Around& around)
    {
        for (Item& item : items) {
            for (Track& track : item.tracks)
                resolve(track, around, item.place);
            if (Group* const group = std::get_if<Group>(&item.content))
                resolve(group->items, around);
            else if (Use* const use = std::get_if<Use>(&item.content))
                resolve(*use, around, item.place);
            else
                resolve(std::get<Object>(item.content), around, item.place);
        }
    }

private:
    void resolve(Track& track, const Around& around, SourceSpan place)
    {
        track.driver = driver_in(around.driver, track.driver, place);
        if (track.property == Property::fill || track.property == Property::stroke)
            for (TrackKey& key : track.keys)
                key.value = static_cast<std::int32_t>(colour_in(around, static_cast<std::size_t>(key.value)));
    }

    void resolve(Use& use, const Around& around, SourceSpan place)
    {
        const Around inside{driver_in(around.driver, std::exchange(use.inner, {}), place),
                            around.colours + std::exchange(use.colour_step, 0)};
        use.symbol = index_of(context_.symbols.entries[use.symbol], inside);
    }

    void resolve(Object& object, const Around& around, SourceSpan place)
    {
        object.driver = driver_in(around.driver, object.driver, place);
        if (object.fill)
            object.fill = colour_in(around, *object.fill);
        if (object.stroke)
            object.stroke->colour = colour_in(around, object.stroke->colour);
        if (object.skin)
            object.skin->bones = bones_by(object.skin->bones, around.driver);
    }

    std::size_t colour_in(const Around& around, std::size_t colour) const
    {
        return around.colours == 0 ? colour : context_.palette.behind(colour, around.colours);
    }

    /// `around` is the same after a whole round through the palette.
    std::size_t index_of(SymbolEntry& symbol, Around around)
    {
        const int declared = static_cast<int>(context_.palette.declared());
        around.colours = declared == 0 ? 0 : (around.colours % declared + declared) % declared;
        const std::pair key{around.driver, around.colours};
        const auto known = symbol.scene_indices.find(key);
        if (known != symbol.scene_indices.end())
            return known->second;
        if (!has_room(symbol) || !take_points_again(symbol))
            return 0;
        std::vector<Item> items = symbol.items;
        resolve(items, around);
        if (!has_room(symbol)) // those that it uses may have taken it
            return 0;
        const std::size_t index = scene_.symbols.size();
        scene_.symbols.push_back({symbol.name, std::move(items)});
        return symbol.scene_indices[key] = index;
    }

    /// Whether there may be one more. The first thing that does not fit is reported, and no symbols are added
    /// after it.
    bool has_room(const SymbolEntry& symbol)
    {
        if (is_full_ || scene_.symbols.size() < max_symbols)
            return !is_full_;
        is_full_ = true;
        return context_.report.error(
            symbol.place, "a scene uses at most " + std::to_string(max_symbols) + " symbols that hold items",
            symbol.scene_indices.empty() ? "" : "each other time, and each step of colours, counts as one");
    }

    /// The points of the first one have been counted where it is written.
    bool take_points_again(const SymbolEntry& symbol)
    {
        is_full_ =
            !symbol.scene_indices.empty() && !take_points(points_of(symbol.items), symbol.place, context_);
        return !is_full_;
    }

    /// Of all drawings; an item and a key count as one.
    static std::size_t points_of(const std::vector<Item>& items)
    {
        std::size_t points = items.size();
        for (const Item& item : items) {
            if (const Group* const group = std::get_if<Group>(&item.content))
                points += points_of(group->items);
            if (const Object* const object = std::get_if<Object>(&item.content))
                for (const Key& key : object->keys)
                    points += point_count(key.drawing) + point_count(key.depths) + 1;
        }
        return points;
    }

    /// `driver` is what is said of keys at `place`.
    Driver driver_in(Driver around, Driver driver, SourceSpan place)
    {
        if (driver.is_time())
            return around;
        if (!driver.is_clock())
            return driver;
        Clock clock = context_.clocks[driver.index()];
        clock.driver = around;
        const auto known = std::ranges::find(scene_.clocks, clock);
        const auto index = static_cast<std::size_t>(known - scene_.clocks.begin());
        if (index == max_clocks) {
            if (!std::exchange(has_too_many_clocks_, true))
                report_too_many_clocks(place, context_);
            return around;
        }
        if (known == scene_.clocks.end())
            scene_.clocks.push_back(clock);
        return Driver::of_clock(index);
    }

    /// The skeleton that moves as this one, by `driver`: a copy, unless it is the time of the scene.
    std::size_t bones_by(std::size_t skeleton, Driver driver)
    {
        if (driver.is_time() || std::ranges::none_of(scene_.bones[skeleton].bones, is_moved_by_time))
            return skeleton;
        const auto [known, is_new] = copies_.try_emplace({skeleton, driver}, scene_.bones.size());
        if (is_new) {
            Bones copy = scene_.bones[skeleton];
            for (Bone& bone : copy.bones)
                bone.driver = bone.driver.is_time() ? driver : bone.driver;
            check_bones(copy);
            scene_.bones.push_back(std::move(copy));
        }
        return known->second;
    }

    static bool is_moved_by_time(const Bone& bone)
    {
        return bone.driver.is_time() &&
               std::ranges::any_of(bone.keys, [](const auto& keys) { return keys.size() > 1; });
    }

    void check_bones(const Bones& copy)
    {
        std::size_t bones = copy.bones.size();
        for (const Bones& skeleton : scene_.bones)
            bones += skeleton.bones.size();
        if (scene_.bones.size() >= max_skeletons || bones > max_bones_together)
            context_.report.error(copy.place, "a scene has at most " + std::to_string(max_skeletons) +
                                                  " skeletons and " + std::to_string(max_bones_together) +
                                                  " bones, counted for each time that they go by");
    }

    Scene& scene_;
    SceneContext& context_;
    std::map<std::pair<std::size_t, Driver>, std::size_t> copies_;
    bool has_too_many_clocks_ = false;
    bool is_full_ = false;
};

}

void add_symbol_instances(Scene& scene, SceneContext& context)
{
    SymbolInstances{scene, context}.resolve(scene.items, {});
}

}
