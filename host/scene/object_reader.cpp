#include "host/scene/object_reader.hpp"

#include "host/scene/default_pivot.hpp"
#include "host/scene/drawing_content.hpp"
#include "host/scene/drawing_reader.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/mirror.hpp"
#include "host/scene/node_form.hpp"
#include "host/scene/object_properties.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/symbol_use.hpp"
#include "host/scene/track_builder.hpp"
#include "host/scene/value_reader.hpp"

#include <array>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

constexpr NodeForm object_form{object_name, "object NAME fill=COLOUR { shapes or keys }", 1, 1, true};

/// What a key may change only where the object has it.
struct Painted {
    Property property;
    std::string_view name;
    std::string_view needs;
};

constexpr std::array painted{
    Painted{Property::fill, "fill", "fill"},
    Painted{Property::stroke, "stroke", "stroke"},
    Painted{Property::width, "width", "stroke"},
};

void refuse_paint_of_nothing(const kdl::Node& object, const std::vector<ItemKey>& keys, Reading& reading)
{
    for (const ItemKey& key : keys)
        for (const Painted& paint : painted)
            if (key.values.get(paint.property) && !has_property(object, paint.needs))
                reading.report.error(property_place(*key.node, paint.name),
                                     "this object has no " + std::string{paint.needs} + " to change",
                                     "add " + std::string{paint.needs} + "=COLOUR to the object");
}

/// What a use may say in place of its object.
struct Placed {
    Property property;
    std::string_view name;
};

constexpr std::array placed{
    Placed{Property::x, "x"},
    Placed{Property::y, "y"},
    Placed{Property::rotation, "rotate"},
    Placed{Property::scale_x, "scale-x"},
    Placed{Property::scale_y, "scale-y"},
};

class ObjectReader {
public:
    ObjectReader(const kdl::Node& node, Reading& reading)
        : node_{node}, place_{span(node.name_place, node.arguments.front().place)}, reading_{reading},
          properties_{read_object_properties(node, place_, reading)}
    {
    }

    Item read(std::string_view name)
    {
        DrawingContent content = read_drawing_content(node_, KeyHolder::object, reading_);
        refuse_paint_of_nothing(node_, content.keys, reading_);
        Object object{.fill = properties_.fill_colour(),
                      .fill_rule = properties_.fill_rule,
                      .stroke = properties_.stroke_style(),
                      .keys = read_drawings(content)};
        auto tracks = build_tracks(node_, properties_.values, content.keys, reading_);
        return {std::string{name}, std::move(tracks), std::move(object), place_};
    }

private:
    std::vector<Key> read_drawings(DrawingContent& content)
    {
        if (content.drawn.size() == 1 && content.drawn.front()->name == use_name)
            return take_symbol(*content.drawn.front(), content.keys);
        std::vector<Key> keys =
            content.drawn.empty() ? take_drawings(content.keys) : read_still(content.drawn);
        if (keys.empty() && content.is_good)
            report_no_drawing();
        set_default_pivot(keys, properties_.values);
        return keys;
    }

    std::vector<Key> read_still(const std::vector<const kdl::Node*>& nodes)
    {
        DrawingReader drawing{reading_};
        drawing.read(nodes);
        return {
            Key{.time = {}, .laws = {}, .match = Match::count, .drawing = drawing.take(), .place = place_}};
    }

    /// The object stands where its use says, so that the drawings stay those of the symbol.
    std::vector<Key> take_symbol(const kdl::Node& node, std::vector<ItemKey>& keys)
    {
        const auto use = read_drawing_use(node, reading_);
        if (!use)
            return {};
        for (const Placed& quantity : placed)
            take_place(node, *use, quantity);
        mirror(use->mirror, properties_.values, keys);
        for (const Key& key : use->symbol->keys)
            if (!take_points(point_count(key.drawing) + 1, node.name_place, reading_))
                return {};
        return use->symbol->keys;
    }

    void take_place(const kdl::Node& node, const SymbolUse& use, const Placed& quantity)
    {
        const auto value = use.values.get(quantity.property);
        if (!value)
            return;
        const std::string name{quantity.name};
        if (properties_.values.get(quantity.property))
            reading_.report.error(node.name_place, "both the object and its use give " + name,
                                  "leave it to one of them");
        properties_.values[quantity.property] = value;
    }

    void report_no_drawing()
    {
        if (node_.children.empty())
            reading_.report.error(place_, "this object has no shapes and no keys",
                                  "add { circle 10 10 r=5 } or { key 0 { … } }");
        else
            reading_.report.error(place_, "this object has no drawing",
                                  "add shapes to the object or to its keys");
    }

    const kdl::Node& node_;
    Place place_;
    Reading& reading_;
    ObjectProperties properties_;
};

}

std::optional<Item> read_object(const kdl::Node& node, Reading& reading)
{
    if (!fits(node, object_form, reading))
        return std::nullopt;
    ObjectReader object{node, reading};
    const auto name = read_name(node.arguments.front(), reading);
    Item item = object.read(name.value_or(""));
    if (!name || !add_name(reading.object_names, "an object", *name, item.place, reading.report))
        return std::nullopt;
    return item;
}

}
