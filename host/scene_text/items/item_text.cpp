#include "host/scene_text/items/item_text.hpp"

#include "host/art/document/document.hpp"
#include "host/kdl/document.hpp"
#include "host/scene_text/bones/rig_text.hpp"
#include "host/scene_text/drawings/drawing_nodes.hpp"
#include "host/scene_text/drawings/stored_drawings.hpp"
#include "host/scene_text/items/dash_text.hpp"
#include "host/scene_text/items/track_text.hpp"
#include "host/scene_text/values/nodes.hpp"
#include "host/scene_text/values/stored_keys.hpp"
#include "host/scene_text/values/writing.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace kfast::scene_text {

namespace {

using art::Shape;

constexpr std::array<std::string_view, 3> cap_words{"butt", "round", "square"};
constexpr std::array<std::string_view, 3> join_words{"miter", "round", "bevel"};

/// All that an object sets at one time.
struct Moment {
    std::vector<kdl::Node> shapes; ///< none: there is no drawing
    std::optional<std::string> fill;
    std::optional<std::string> stroke;
    std::optional<std::string> dash;
    std::optional<bool> visible;
    std::optional<std::string> drawing_law; ///< of the transitions that begin here
    std::optional<std::string> paint_law;
    bool matches_length = false;
};

class ObjectText {
public:
    ObjectText(const art::Node& node, Writing& writing)
        : node_{node},
          shape_{std::get<Shape>(node.content)},
          writing_{writing},
          drawings_{drawing_keys(shape_, writing.length)}
    {
    }

    kdl::Node write()
    {
        name_ = writing_.object_names.unique(node_.name, "shape");
        object_ = named_node("object", text(name_));
        add_fill();
        add_line();
        add_dashes();
        add_visibility();
        add_shapes();
        if (shape_.skin)
            add_skin(object_, *shape_.skin, writing_.rigs[shape_.skin->rig]);
        add_width();
        add_trim();
        add_dash_offset();
        add_transform(object_, node_.transform, node_.opacity, default_pivot(drawings_), writing_);
        return std::move(object_);
    }

private:
    void add_fill()
    {
        if (!shape_.fill)
            return;
        add_paint("fill", *shape_.fill, name_, &Moment::fill);
        if (shape_.fill->rule == FillRule::even_odd)
            set(object_, "rule", text("even-odd"));
    }

    void add_line()
    {
        if (!shape_.stroke)
            return;
        const art::StrokeStyle& stroke = *shape_.stroke;
        add_paint("stroke", stroke, shape_.fill ? name_ + "-line" : name_, &Moment::stroke);
        if (stroke.cap != Cap::butt)
            set(object_, "cap", text(std::string{cap_words[static_cast<std::size_t>(stroke.cap)]}));
        if (stroke.join != Join::miter)
            set(object_, "join", text(std::string{join_words[static_cast<std::size_t>(stroke.join)]}));
        const std::int32_t miter = on_grid(stroke.miter_limit, miters);
        if (stroke.join == Join::miter && miter != default_miter_limit)
            set(object_, "miter", number(miter, miters));
    }

    /// The first value stands in the object, as other keys may begin earlier.
    void add_dashes()
    {
        if (!has_dashes())
            return;
        const DashKeys keys = dash_keys(shape_, writing_);
        set(object_, "dash", text(keys.front().value));
        if (keys.size() > 1)
            for (const auto& [ticks, key] : among_paints(keys)) {
                Moment& moment = moments_[ticks];
                moment.dash = key->value;
                if (key != &keys.back())
                    moment.paint_law = key->law;
            }
    }

    bool has_dashes() const { return shape_.stroke && !shape_.stroke->dashes.lengths.empty(); }

    using PlacedKeys = std::map<std::int32_t, const DashKeys::value_type*>;

    /// The keys by their ticks: where a colour goes by another law from there on, a tick earlier, and at the
    /// beginning a tick later. They are placed from the last one on, which begins nothing.
    PlacedKeys among_paints(const DashKeys& keys) const
    {
        PlacedKeys placed{{keys.back().ticks, &keys.back()}};
        for (auto key = std::next(keys.rbegin()); key != keys.rend(); ++key) {
            const std::int32_t next = placed.begin()->first;
            std::int32_t ticks = std::min(key->ticks, next - 1);
            while (ticks >= 0 && !allows(ticks, key->law))
                --ticks;
            if (ticks < 0)
                for (ticks = 1; ticks < next && !allows(ticks, key->law);)
                    ++ticks;
            placed.emplace(ticks, &*key); // what has no room is left out
        }
        return placed;
    }

    /// Whether colours have no key there that goes by another law.
    bool allows(std::int32_t ticks, const std::string& law) const
    {
        const auto moment = moments_.find(ticks);
        return moment == moments_.end() || moment->second.paint_law.value_or(law) == law;
    }

    void add_dash_offset()
    {
        if (!has_dashes())
            return;
        const art::Channel& offset = shape_.stroke->dashes.offset;
        add_quantity(object_, "dash-offset", stored_keys(offset, writing_.length, dash_offsets), dash_offsets,
                     0);
    }

    template <typename Paint>
    void add_paint(std::string_view property, const Paint& paint, const std::string& user,
                   std::optional<std::string> Moment::*place)
    {
        const auto keys = paint_keys(paint, writing_.length);
        set(object_, property, text(writing_.colours.word(keys.front().value, user)));
        if (keys.size() == 1)
            return;
        for (const auto& key : keys) {
            Moment& moment = moments_[key.ticks];
            moment.*place = writing_.colours.word(key.value, user);
            if (&key != &keys.back())
                moment.paint_law = key.law;
        }
    }

    void add_visibility()
    {
        const auto keys = visible_keys(node_.shown, writing_.length);
        if (keys.size() > 1)
            for (const auto& key : keys)
                moments_[key.ticks].visible = key.value;
    }

    void add_shapes()
    {
        if (drawings_.size() > 1)
            add_drawings();
        else
            object_.children = shapes().front();
        for (const auto& [ticks, moment] : moments_)
            object_.children.push_back(key_node(ticks, moment));
    }

    std::vector<std::vector<kdl::Node>> shapes() const
    {
        std::vector<const art::Drawing*> drawings;
        for (const auto& key : drawings_)
            drawings.push_back(&key.value);
        return shapes_of(drawings);
    }

    void add_drawings()
    {
        std::vector<std::vector<kdl::Node>> nodes = shapes();
        for (std::size_t i = 0; i < drawings_.size(); ++i) {
            const auto& key = drawings_[i];
            Moment& moment = moments_[key.ticks];
            moment.shapes = std::move(nodes[i]);
            if (i + 1 == drawings_.size())
                continue;
            moment.drawing_law = key.law;
            moment.matches_length = shape_.matches_length && !shape_.skin && key.law != "hold" &&
                                    !same_form(key.value, drawings_[i + 1].value);
        }
    }

    static void add_laws(kdl::Node& key, const Moment& moment)
    {
        const std::string rest = moment.paint_law.value_or(moment.drawing_law.value_or("constant"));
        if (rest != "constant")
            set(key, "law", text(rest));
        if (moment.drawing_law && *moment.drawing_law != rest)
            for (const std::string_view axis : {"law-x", "law-y"})
                set(key, axis, text(*moment.drawing_law));
    }

    static kdl::Node key_node(std::int32_t ticks, const Moment& moment)
    {
        kdl::Node key = named_node("key", number(ticks, times));
        add_laws(key, moment);
        if (moment.matches_length)
            set(key, "match", text("length"));
        if (moment.fill)
            set(key, "fill", text(*moment.fill));
        if (moment.stroke)
            set(key, "stroke", text(*moment.stroke));
        if (moment.dash)
            set(key, "dash", text(*moment.dash));
        if (moment.visible)
            set(key, "visible", truth(*moment.visible));
        key.children = moment.shapes;
        return key;
    }

    void add_width()
    {
        if (!shape_.stroke)
            return;
        const NumberKeys keys = stored_keys(shape_.stroke->width, writing_.length, widths);
        const bool is_still = keys.size() == 1;
        add_quantity(object_, "width", is_still ? held(keys) : keys, is_still ? still_widths : widths,
                     on_grid(1, widths));
    }

    void add_trim()
    {
        if (!shape_.trim)
            return;
        const auto add = [this](std::string_view name, const art::Channel& channel, const Grid& grid,
                                double whole) {
            add_quantity(object_, name, stored_keys(channel, writing_.length, grid), grid,
                         on_grid(whole, grid));
        };
        add("trim-from", shape_.trim->start, shares, 0);
        add("trim-to", shape_.trim->end, shares, 1);
        add("trim-offset", shape_.trim->offset, offsets, 0);
        if (shape_.trim->together)
            set(object_, "trim", text("together"));
    }

    /// A width of 0 is allowed only in keys.
    static NumberKeys held(NumberKeys keys)
    {
        keys.front().value = std::max(keys.front().value, 1);
        return keys;
    }

    const art::Node& node_;
    const Shape& shape_;
    Writing& writing_;
    std::vector<StoredKey<art::Drawing>> drawings_;
    std::string name_ = {};
    kdl::Node object_ = {};
    std::map<std::int32_t, Moment> moments_ = {};
};

/// The node `object` of a node that is a shape.
kdl::Node object_node(const art::Node& node, Writing& writing) { return ObjectText{node, writing}.write(); }

void add_visibility(kdl::Node& item, const art::Node& node, const Writing& writing)
{
    const auto keys = visible_keys(node.shown, writing.length);
    if (keys.size() == 1)
        return;
    for (const auto& key : keys) {
        kdl::Node moment = named_node("key", number(key.ticks, times));
        set(moment, "visible", truth(key.value));
        item.children.push_back(std::move(moment));
    }
}

kdl::Node group_node(const art::Node& node, Writing& writing)
{
    kdl::Node group = named_node("group");
    if (const std::string name = clean_name(node.name, ""); !name.empty())
        group.arguments.push_back(text(name));
    add_transform(group, node.transform, node.opacity, {}, writing);
    add_visibility(group, node, writing);
    std::vector<kdl::Node> items = item_nodes(std::get<art::Group>(node.content).nodes, writing);
    std::ranges::move(items, std::back_inserter(group.children));
    return group;
}

void add_copies(kdl::Node& item, const art::Copies& copies)
{
    if (copies.count == 1)
        return;
    check_step(copies.x);
    check_step(copies.y);
    set(item, "count", number(static_cast<std::size_t>(copies.count)));
    const auto add = [&item](std::string_view name, double step, double ordinary) {
        if (const kdl::Value value = exact(step); step != ordinary)
            set(item, name, value);
    };
    add("x-step", copies.x, 0);
    add("y-step", copies.y, 0);
    add("rotate-step", copies.rotation, 0);
    add("scale-step", copies.scale, 1);
    add("opacity-step", copies.opacity, 0);
}

kdl::Node use_node(const art::Node& node, const Writing& writing)
{
    const auto& use = std::get<art::Use>(node.content);
    kdl::Node item = named_node("use", text(writing.symbols[use.symbol]));
    add_transform(item, node.transform, node.opacity, {}, writing);
    if (const std::int32_t delay = on_grid(use.delay, signed_times); delay != 0)
        set(item, "delay", number(delay, signed_times));
    if (const std::int32_t speed = on_grid(use.speed, speeds); speed != on_grid(1, speeds))
        set(item, "speed", number(speed, speeds));
    add_copies(item, use.copies);
    add_visibility(item, node, writing);
    return item;
}

kdl::Node item_node(const art::Node& node, Writing& writing)
{
    if (std::holds_alternative<Shape>(node.content))
        return object_node(node, writing);
    if (std::holds_alternative<art::Use>(node.content))
        return use_node(node, writing);
    return group_node(node, writing);
}

}

std::vector<kdl::Node> item_nodes(const std::vector<art::Node>& nodes, Writing& writing)
{
    std::vector<kdl::Node> items;
    items.reserve(nodes.size());
    for (const art::Node& node : nodes)
        items.push_back(item_node(node, writing));
    return items;
}

}
