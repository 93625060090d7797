#include "host/scene/items/object_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/items/drawing_content.hpp"
#include "host/scene/items/drawing_reader.hpp"
#include "host/scene/items/object_dashes.hpp"
#include "host/scene/items/object_properties.hpp"
#include "host/scene/items/sector_trim.hpp"
#include "host/scene/items/skeleton_reader.hpp"
#include "host/scene/items/symbol_use.hpp"
#include "host/scene/items/track_builder.hpp"
#include "host/scene/shapes/label_reader.hpp"
#include "host/scene/skeleton/skin_reader.hpp"
#include "host/scene/values/input_user.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

constexpr NodeForm object_form{object_name, "object NAME fill=COLOUR { shapes or keys }", 1, 1, true};

/// What keys and tracks may change only where the object has it.
struct Painted {
    Property property;
    std::string_view needs;
};

constexpr std::array painted{
    Painted{Property::fill, "fill"},     Painted{Property::stroke, "stroke"},
    Painted{Property::width, "stroke"},  Painted{Property::dash_offset, "stroke"},
    Painted{Property::dash_1, "stroke"},
};

void report_paint_of_nothing(std::string_view needs, SourceSpan place, SceneContext& context)
{
    const std::string name{needs};
    context.report.error(place, "this object has no " + name + " to change",
                         "add " + name + "=COLOUR to the object");
}

void refuse_dashes_of_nothing(const kdl::Node& object, SceneContext& context)
{
    if (has_property(object, "stroke"))
        return;
    for (const std::string_view property : {"dash", "dash-offset"})
        if (has_property(object, property))
            context.report.error(property_span(object, property), "this object has no stroke to dash",
                                 "add stroke=COLOUR, or remove " + std::string{property});
}

void refuse_paint_of_nothing(const kdl::Node& object, const DrawingContent& content, SceneContext& context)
{
    refuse_dashes_of_nothing(object, context);
    for (const Painted& paint : painted) {
        if (has_property(object, paint.needs))
            continue;
        for (const ItemKey& key : content.keys)
            if (key.values.get(paint.property))
                report_paint_of_nothing(paint.needs, property_span(*key.node, property_name(paint.property)),
                                        context);
        for (const TimedQuantity& quantity : content.timed)
            if (gives(quantity, paint.property))
                report_paint_of_nothing(paint.needs, quantity.place, context);
    }
}

/// What a use may set in place of its object.
constexpr std::array placed{Property::x,          Property::y,        Property::z,       Property::rotation_x,
                            Property::rotation_y, Property::rotation, Property::scale_x, Property::scale_y};

bool has_skeleton(const ItemKey& key) { return key.skeleton != nullptr; }

class ObjectReader {
public:
    ObjectReader(const kdl::Node& node, SceneContext& context)
        : node_{node},
          place_{span(node.name_span, node.arguments.front().place)},
          context_{context},
          properties_{read_object_properties(node, place_, context)}
    {
    }

    Item read(std::string_view name)
    {
        context_.line_letters.reset();
        DrawingContent content = read_drawing_content(node_, KeyHolder::object, properties_.driver, context_);
        warn_of_idle_input(node_, !content.keys.empty(), context_);
        refuse_paint_of_nothing(node_, content, context_);
        Object object{.fill = properties_.fill_colour(),
                      .fill_rule = properties_.fill_rule,
                      .stroke = properties_.stroke_style(),
                      .keys = {},
                      .beam = properties_.beam};
        if (is_placed_label(content))
            set_label(content, object);
        else
            draw(content, object);
        if (!object.stroke)
            warn_of_filled_lines();
        make_dashes_alike(node_, properties_.values, content.keys, context_);
        auto tracks = build_tracks(node_, properties_.values,
                                   {content.keys, properties_.driver.driver(), object.has_depths},
                                   content.timed, context_);
        add_trim(tracks, object);
        add_max_dashes(tracks, object, place_, context_);
        std::ranges::sort(tracks, {}, &Track::property);
        return {std::string{name}, std::move(tracks), std::move(object), place_, take_path(content.timed)};
    }

private:
    bool is_placed_label(const DrawingContent& content) const
    {
        return properties_.live == nullptr && content.drawn.size() == 1 && is_label(*content.drawn.front());
    }

    void warn_of_filled_lines()
    {
        if (const auto& letters = context_.line_letters)
            context_.report.warning(letters->place,
                                    "the letters of " + letters->font +
                                        " are lines, which a fill does not show, and there is no stroke",
                                    "give the object a stroke=COLOUR, or the text font=" +
                                        std::string{FontShelf::bundled_names().front()});
    }

    void draw(DrawingContent& content, Object& object)
    {
        object.keys = read_drawings(content);
        if (is_wire_frame(object.keys))
            return set_wires(content, object);
        object.skin = read_skin({properties_.skin, properties_.bone, properties_.bones,
                                 properties_.turns_changes, content.weights, place_},
                                object.keys, context_);
        if (object.skin)
            take_bone_keys(*object.skin);
        object.backbone_keys = read_skeletons(content.keys, context_);
        object.driver = drawing_driver();
        object.live = live_;
        refuse_two_deformers(content.keys);
        refuse_backbones_by_clock(content.keys);
    }

    /// What the bones do belongs to the time of a symbol with this object.
    void take_bone_keys(const Skin& skin)
    {
        for (const Bone& bone : context_.skeletons.entries[skin.bones].bones.bones)
            for (const std::vector<TrackKey>& keys : bone.keys)
                if (bone.driver.is_time() && !keys.empty())
                    context_.last_key = std::max(context_.last_key, keys.back().time);
    }

    Driver drawing_driver() const { return inner_.is_clock() ? inner_ : properties_.driver.driver(); }

    /// Arcs and pies that change their angles are trimmed, unless the author trims them. The lines of dashed
    /// pies have dashes, too, which their angles do not know.
    void add_trim(std::vector<Track>& tracks, Object& object) const
    {
        const auto has_track = [&tracks](auto is_wanted) {
            return std::ranges::any_of(tracks, is_wanted, &Track::property);
        };
        const bool is_bent = object.skin || !object.backbone_keys.empty() || object.has_depths;
        const bool has_pies = are_pies(object.keys);
        if (is_bent || (has_pies && has_track(is_dash_length)))
            return;
        if (!has_track(is_of_trim))
            std::ranges::move(trim_sectors(object.keys, object.driver), std::back_inserter(tracks));
        else if (has_pies && !has_track([](Property property) { return property == Property::trim_mode; }))
            tracks.push_back(trim_by_angles());
    }

    void set_wires(const DrawingContent& content, Object& object)
    {
        object.has_depths = true;
        object.driver = drawing_driver();
        refuse_mixed_depths(object.keys, context_);
        refuse_beside_wires(node_, content, object.keys, context_);
    }

    void set_label(const DrawingContent& content, Object& object)
    {
        refuse_deformers_of_label(content);
        refuse_duplicates(content);
        object.label = read_label(*content.drawn.front(), context_);
        if (object.label)
            set_default_pivot(object.label->pivot, properties_.values);
    }

    void refuse_deformers_of_label(const DrawingContent& content)
    {
        constexpr auto hint = "remove this, or write the words themselves";
        const auto refuse = [this](SourceSpan place, std::string_view deformer) {
            context_.report.error(place, "the text of an input has no " + std::string{deformer}, hint);
        };
        for (const std::string_view property : {"skin", "bone", "bones"})
            if (has_property(node_, property))
                refuse(property_span(node_, property), property);
        if (content.weights != nullptr)
            refuse(content.weights->name_span, "weights");
        const auto key = std::ranges::find_if(content.keys, has_skeleton);
        if (key != content.keys.end())
            refuse(key->skeleton->name_span, "skeleton");
    }

    std::vector<Key> read_drawings(DrawingContent& content)
    {
        if (properties_.live != nullptr)
            return read_live(*properties_.live, content);
        if (is_placed_symbol(content))
            return take_symbol(*content.drawn.front(), content);
        refuse_duplicates(content);
        std::vector<Key> keys =
            content.drawn.empty() ? take_drawings(content.keys) : read_still(content.drawn);
        if (keys.empty() && content.is_valid)
            report_no_drawing();
        set_default_pivot(keys, properties_.values);
        return keys;
    }

    /// The drawing is that of the input, and there are no keys of it.
    std::vector<Key> read_live(const kdl::Value& name, DrawingContent& content)
    {
        refuse_duplicates(content);
        refuse_own_drawings(content);
        live_ = use_input(name, InputType::drawing, context_);
        if (live_)
            set_default_pivot({{.time = {},
                                .laws = {},
                                .drawing = context_.inputs.entries[*live_].input.drawing.default_value,
                                .place = {}}},
                              properties_.values);
        return {};
    }

    void refuse_own_drawings(DrawingContent& content)
    {
        for (const kdl::Node* drawn : content.drawn)
            report_own_drawing(drawn->name_span);
        for (const Key& key : take_drawings(content.keys))
            report_own_drawing(key.place);
        for (ItemKey& key : content.keys)
            if (const kdl::Node* const skeleton = std::exchange(key.skeleton, nullptr))
                report_own_drawing(skeleton->name_span);
        if (properties_.skin != nullptr)
            report_own_drawing(property_span(node_, "skin"));
        if (content.weights != nullptr && properties_.skin == nullptr)
            report_own_drawing(content.weights->name_span);
        properties_.skin = nullptr;
        content.weights = nullptr;
    }

    void report_own_drawing(SourceSpan place)
    {
        context_.report.error(place, "this object shows an input, and has no drawing or skeleton of its own",
                              "put shapes into the input, or remove live=…");
    }

    /// A skin needs the drawing itself to be at the position of the use.
    bool is_placed_symbol(const DrawingContent& content) const
    {
        return content.drawn.size() == 1 && content.drawn.front()->name == use_name &&
               !has_property(*content.drawn.front(), "count") && properties_.skin == nullptr;
    }

    std::vector<Key> read_still(const std::vector<const kdl::Node*>& nodes)
    {
        DrawingReader drawing{context_};
        drawing.read(nodes);
        return {Key{.time = {},
                    .laws = {},
                    .match = Match::count,
                    .drawing = drawing.take(),
                    .depths = drawing.take_depths(),
                    .place = place_,
                    .sectors = drawing.take_sectors()}};
    }

    /// The object gets the position of its use, so that the drawings stay those of the symbol.
    std::vector<Key> take_symbol(const kdl::Node& node, DrawingContent& content)
    {
        const auto use = read_drawing_use(node, context_);
        if (!use)
            return {};
        inner_ = use->inner;
        for (const Property property : placed)
            take_place(node, *use, property);
        refuse_duplicates(content);
        mirror(use->mirror, properties_.values, content.keys, content.timed);
        if (use->symbol->keys.size() > 1 && !properties_.driver.is_time())
            context_.report.error(node.name_span,
                                  "this object goes by an input, but the drawings of its symbol by the time",
                                  "leave out input=, or draw the keys in the object");
        for (const Key& key : use->symbol->keys)
            if (!take_points(point_count(key.drawing) + point_count(key.depths) + 1, node.name_span,
                             context_))
                return {};
        return use->symbol->keys;
    }

    void take_place(const kdl::Node& node, const SymbolUse& use, Property property)
    {
        const auto value = use.values.get(property);
        if (!value)
            return;
        if (properties_.values.get(property))
            context_.report.error(node.name_span,
                                  "both the object and its use give " + std::string{property_name(property)},
                                  "leave it to one of them");
        properties_.values[property] = value;
    }

    /// Called before the values of the object contain anything that neither it nor its use sets.
    void refuse_duplicates(const DrawingContent& content)
    {
        refuse_duplicate_quantities(content.timed, properties_.values, content.keys, context_);
    }

    void refuse_two_deformers(const std::vector<ItemKey>& keys)
    {
        const auto key = std::ranges::find_if(keys, has_skeleton);
        if (key != keys.end() && has_property(node_, "skin"))
            context_.report.error(key->skeleton->name_span,
                                  "this object has a skin; bones or backbones carry an object, not both",
                                  "remove the skin, or the skeletons from the keys");
    }

    void refuse_backbones_by_clock(const std::vector<ItemKey>& keys)
    {
        const auto key = std::ranges::find_if(keys, has_skeleton);
        if (key != keys.end() && inner_.is_clock())
            context_.report.error(
                key->skeleton->name_span,
                "the drawings of this object have a time of their own, which a skeleton does "
                "not go by",
                "draw the keys in the object");
    }

    void report_no_drawing()
    {
        if (node_.children.empty())
            context_.report.error(place_, "this object has no shapes and no keys",
                                  "add { circle 10 10 r=5 } or { key 0 { … } }");
        else
            context_.report.error(place_, "this object has no drawing",
                                  "add shapes to the object or to its keys");
    }

    const kdl::Node& node_;
    SourceSpan place_;
    SceneContext& context_;
    ObjectProperties properties_;
    std::optional<std::size_t> live_ = {}; ///< the input that is shown
    Driver inner_ = {};                    ///< of the drawings of a symbol
};

}

std::optional<Item> read_object(const kdl::Node& node, SceneContext& context)
{
    if (!fits(node, object_form, context.report))
        return std::nullopt;
    ObjectReader object{node, context};
    const auto name = read_name(node.arguments.front(), context.report);
    Item item = object.read(name.value_or(""));
    if (!name || !add_name(context.object_names, "an object", *name, item.place, context.report))
        return std::nullopt;
    return item;
}

NodeSchema object_schema()
{
    return {object_name,
            object_form,
            {any_name},
            object_property_schema(),
            drawn_ids(names_in_drawing(KeyHolder::object))};
}

}
