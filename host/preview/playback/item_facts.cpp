#include "host/preview/playback/item_facts.hpp"

#include "core/pose/item_state.hpp"
#include "core/time/track.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/walk/key_times.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kfast {
namespace {

/// For both axes if they have the same law, and for values without laws.
std::string text_of(const LawPair& laws)
{
    if (laws.x == laws.y)
        return law_text(laws.x);
    return "x " + law_text(laws.x) + ", y " + law_text(laws.y);
}

bool is_colour(Property property) { return property == Property::fill || property == Property::stroke; }

std::string value_text(const SceneView& scene, Property property, std::int32_t value)
{
    if (is_colour(property))
        return colour_text(scene.colour(static_cast<std::size_t>(value)));
    if (property == Property::visible)
        return value != 0 ? "#true" : "#false";
    return rounded_text(written_amount(property, value));
}

std::string law_between(const SceneView& scene, const TrackView& track, const TrackKey& key)
{
    if (track.property == Property::order || track.property == Property::visible)
        return "";
    if (track.is_smooth)
        return "smooth";
    const LawPair laws = scene.laws(key.laws);
    return law_text(goes_by_y(track.property) ? laws.y : laws.x);
}

Quantity quantity_of(const SceneView& scene, const TrackView& track)
{
    Quantity quantity{std::string{property_name(track.property)}, track.keys.key_times().driver()};
    for (TrackKeyCursor keys = track.keys; !keys.at_end();) {
        const TrackKey key = keys.next();
        quantity.keys.push_back({key.time, value_text(scene, track.property, key.value),
                                 keys.at_end() ? "" : law_between(scene, track, key)});
    }
    return quantity;
}

template <class KeyCursor>
Quantity quantity_of(const SceneView& scene, std::string name, KeyCursor keys)
{
    Quantity quantity{std::move(name), keys.key_times().driver()};
    while (!keys.at_end()) {
        const auto key = keys.next();
        quantity.keys.push_back({key.time, "", keys.at_end() ? "" : text_of(scene.laws(key.laws))});
    }
    return quantity;
}

void add_deformers(const SceneView& scene, const ItemView& item, std::vector<Quantity>& quantities)
{
    if (item.object.deformer == Deformer::backbones)
        quantities.push_back(quantity_of(scene, "backbones", item.object.backbones.keys()));
    if (item.object.deformer != Deformer::bones)
        return;
    Quantity bones{"bones"};
    for (const Time time : bone_key_times(scene, item))
        bones.keys.push_back({time});
    if (!bones.keys.empty())
        quantities.push_back(std::move(bones));
}

/// Joins two that are the same.
void join_scales(std::vector<Quantity>& quantities)
{
    const auto x = std::ranges::find(quantities, "scale-x", &Quantity::name);
    const auto y = std::ranges::find(quantities, "scale-y", &Quantity::name);
    if (x == quantities.end() || y == quantities.end() || x->driver != y->driver || x->keys != y->keys)
        return;
    x->name = "scale";
    quantities.erase(y);
}

/// Properties that are always listed, whatever tracks there are, in their order.
constexpr std::array always_listed{Property::x,       Property::y,        Property::scale_x,
                                   Property::scale_y, Property::rotation, Property::opacity};

class ValueList {
public:
    ValueList(const SceneOnPanel& on_panel, const Node& item)
        : scene_{on_panel.scene}, prepared_{on_panel.prepared}, item_{item}
    {
    }

    std::vector<ItemValue> all()
    {
        for (const Property property : always_listed)
            add(property);
        join_equal_scales();
        for (const TrackState& track : prepared_.tracks(item_)) {
            const auto property = static_cast<Property>(track.property);
            if (std::ranges::find(always_listed, property) == always_listed.end() && !is_painted(property))
                add(property);
        }
        add_paint();
        return std::move(values_);
    }

private:
    static bool is_painted(Property property) { return is_colour(property) || property == Property::width; }

    const TrackState* track(Property property) const
    {
        const auto tracks = prepared_.tracks(item_);
        const auto found =
            std::ranges::find(tracks, static_cast<std::uint8_t>(property), &TrackState::property);
        return found == tracks.end() ? nullptr : &*found;
    }

    bool has_keys(Property property) const
    {
        const TrackState* const found = track(property);
        return found != nullptr && found->has_timeline();
    }

    /// In the unit of the property, with its fraction.
    double amount(Property property) const
    {
        const TrackState* const found = track(property);
        constexpr double fine_one = 1 << fine_bits;
        return found == nullptr ? value_without_track(property)
                                : prepared_.fine_value(scene_, *found) / fine_one;
    }

    void add(Property property, std::string value)
    {
        values_.push_back({std::string{property_name(property)}, std::move(value), has_keys(property)});
    }

    void add(Property property)
    {
        const double stored = amount(property);
        if (property == Property::visible)
            return add(property, value_text(scene_, property, static_cast<std::int32_t>(stored)));
        add(property, rounded_text(std::round(written_amount(property, stored) * 1000) / 1000));
    }

    void join_equal_scales()
    {
        const auto x = std::ranges::find(values_, "scale-x", &ItemValue::name);
        const auto y = std::next(x);
        if (x->value != y->value)
            return;
        x->name = "scale";
        x->has_keys = x->has_keys || y->has_keys;
        values_.erase(y);
    }

    void add_paint()
    {
        const ObjectStyle& style = item_.style;
        if (!item_.is_leaf())
            return;
        const ItemState state{scene_, prepared_, item_};
        if (style.is_filled)
            add(Property::fill, colour_text(state.fill()));
        if (!style.is_stroked)
            return;
        add(Property::stroke, colour_text(state.stroke()));
        constexpr double one = Fixed::one;
        add(Property::width, rounded_text(std::round(state.width().raw() / one * 1000) / 1000));
    }

    const SceneView& scene_;
    const PreparedScene& prepared_;
    const Node& item_;
    std::vector<ItemValue> values_;
};

std::string text_of(const SceneView& scene, Driver driver, const QuantityKey* key)
{
    if (key == nullptr)
        return "";
    std::string text = rounded_text(written_moment(scene, driver, key->time));
    if (!key->value.empty())
        text += ": " + key->value;
    if (!key->law.empty())
        text += (key->value.empty() ? ": " : ", ") + key->law;
    return text;
}

ItemFacts::Way way_at(const SceneView& scene, const Quantity& quantity, const SceneTime& moment)
{
    const auto [before, after] = keys_around(quantity, moment.at(quantity.driver));
    std::string name = quantity.name;
    if (quantity.driver.is_clock())
        name += " by a time of its own";
    else if (quantity.driver.is_input())
        name += " by " + visible(input_of(scene, quantity.driver).name);
    return {std::move(name), text_of(scene, quantity.driver, before), text_of(scene, quantity.driver, after)};
}

}

std::vector<Quantity> quantities_of(const SceneView& scene, const ItemView& item)
{
    std::vector<Quantity> quantities;
    if (item.kind == ItemKind::object) {
        quantities.push_back(quantity_of(scene, "shape", item.object.keys()));
        add_deformers(scene, item, quantities);
    }
    for (TrackCursor tracks = item.tracks; !tracks.at_end();)
        if (const TrackView track = tracks.next(); !track.is_fixed)
            quantities.push_back(quantity_of(scene, track));
    join_scales(quantities);
    return quantities;
}

KeysAround keys_around(const Quantity& quantity, Time moment)
{
    KeysAround around;
    for (const QuantityKey& key : quantity.keys) {
        if (key.time > moment) {
            around.after = &key;
            break;
        }
        around.before = &key;
    }
    return around;
}

ItemFacts facts_at(const SceneOnPanel& on_panel, const ItemView& item, const SceneTime& moment)
{
    const SceneView& scene = on_panel.scene;
    const auto node = std::ranges::find(on_panel.prepared.nodes(), scene.place_of(item.place), &Node::place);
    ItemFacts facts{ValueList{on_panel, *node}.all(), {}};
    for (const Quantity& quantity : quantities_of(scene, item))
        if (quantity.keys.size() > 1)
            facts.ways.push_back(way_at(scene, quantity, moment));
    return facts;
}

}
