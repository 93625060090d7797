#include "host/scene_text/items/track_text.hpp"

#include "host/scene_text/drawings/stored_drawings.hpp"
#include "host/scene_text/values/nodes.hpp"
#include "host/scene_text/values/sums.hpp"

#include <algorithm>
#include <map>

namespace kfast::scene_text {
namespace {

using art::Channel;
using art::Transform;

/// Half of the unit that coordinates are rounded to.
constexpr double half_step = 1.0 / 32;

bool same_key(const StoredKey<std::int32_t>& one, const StoredKey<std::int32_t>& other)
{
    return one.ticks == other.ticks && one.value == other.value && one.law == other.law;
}

/// The most common law of the transitions; the last key begins none.
std::string commonest_law(const NumberKeys& keys)
{
    std::map<std::string, std::size_t> counts;
    for (std::size_t i = 0; i + 1 < keys.size(); ++i)
        ++counts[keys[i].law];
    return std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; })->first;
}

void add_values(kdl::Node& track, const NumberKeys& keys, const Grid& grid)
{
    const std::string law = keys.size() > 1 ? commonest_law(keys) : std::string{};
    if (keys.size() > 1)
        set(track, "law", text(law));
    for (const auto& key : keys) {
        kdl::Node at = named_node("at", number(key.ticks, times), number(key.value, grid));
        if (&key != &keys.back() && key.law != law)
            set(at, "law", text(key.law));
        track.children.push_back(std::move(at));
    }
}

class TransformText {
public:
    TransformText(kdl::Node& item, const Transform& transform, scene::Point pivot, const Writing& writing)
        : item_{item},
          transform_{transform},
          pivot_{pivot},
          length_{writing.length},
          sampling_{half_step, writing.budget}
    {
    }

    void add()
    {
        add_place();
        add_plain("z", transform_.z, coordinates, 0);
        add_pivot();
        add_plain("rotate", transform_.rotate, degrees, 0);
        add_plain("rotate-x", transform_.rotate_x, degrees, 0);
        add_plain("rotate-y", transform_.rotate_y, degrees, 0);
        add_scale();
    }

private:
    void add_plain(std::string_view name, const Channel& channel, const Grid& grid, std::int32_t ordinary)
    {
        add_quantity(item_, name, stored_keys(channel, length_, grid), grid, ordinary);
    }

    void add_place()
    {
        if (transform_.path)
            return add_path(*transform_.path);
        add_plain("x", sum(transform_.x, scaled(transform_.anchor_x, -1), sampling_), coordinates, 0);
        add_plain("y", sum(transform_.y, scaled(transform_.anchor_y, -1), sampling_), coordinates, 0);
    }

    void add_path(const art::MotionPath& motion)
    {
        const art::Drawing path = on_grid(motion.path);
        kdl::Node track = named_node("track", text("along"), text(path_data(path.outlines.front())));
        if (motion.turns)
            set(track, "turn", truth(true));
        add_values(track, stored_keys(motion.share, length_, shares), shares);
        item_.children.push_back(std::move(track));
    }

    bool stands_at(const Channel& channel, const Grid& grid, std::int32_t ordinary) const
    {
        const NumberKeys keys = stored_keys(channel, length_, grid);
        return keys.size() == 1 && keys.front().value == ordinary;
    }

    bool needs_pivot() const
    {
        const std::int32_t whole = on_grid(1, scales);
        return transform_.path || !stands_at(transform_.rotate, degrees, 0) ||
               !stands_at(transform_.rotate_x, degrees, 0) || !stands_at(transform_.rotate_y, degrees, 0) ||
               !stands_at(transform_.scale_x, scales, whole) || !stands_at(transform_.scale_y, scales, whole);
    }

    void add_pivot()
    {
        if (!needs_pivot())
            return;
        add_plain("pivot-x", transform_.anchor_x, coordinates, pivot_.x);
        add_plain("pivot-y", transform_.anchor_y, coordinates, pivot_.y);
    }

    void add_scale()
    {
        const NumberKeys across = stored_keys(transform_.scale_x, length_, scales);
        const NumberKeys down = stored_keys(transform_.scale_y, length_, scales);
        const std::int32_t whole = on_grid(1, scales);
        if (std::ranges::equal(across, down, same_key))
            return add_quantity(item_, "scale", across, scales, whole);
        add_quantity(item_, "scale-x", across, scales, whole);
        add_quantity(item_, "scale-y", down, scales, whole);
    }

    kdl::Node& item_;
    const Transform& transform_;
    scene::Point pivot_;
    std::int32_t length_;
    Sampling sampling_;
};

}

void add_quantity(kdl::Node& item, std::string_view quantity, const NumberKeys& keys, const Grid& grid,
                  std::optional<std::int32_t> ordinary)
{
    if (keys.size() > 1) {
        kdl::Node track = named_node("track", text(std::string{quantity}));
        add_values(track, keys, grid);
        item.children.push_back(std::move(track));
    } else if (keys.front().value != ordinary) {
        set(item, quantity, number(keys.front().value, grid));
    }
}

void add_transform(kdl::Node& item, const Transform& transform, const Channel& opacity, scene::Point pivot,
                   const Writing& writing)
{
    TransformText{item, transform, pivot, writing}.add();
    add_quantity(item, "opacity", stored_keys(opacity, writing.length, opacities), opacities,
                 on_grid(1, opacities));
}

}
