#include "host/scene/items/drawing_content.hpp"

#include "host/scene/items/drawing_reader.hpp"
#include "host/scene/items/item_reader.hpp"
#include "host/scene/items/key_list.hpp"
#include "host/scene/items/symbol_use.hpp"
#include "host/scene/items/track_reader.hpp"
#include "host/scene/skeleton/weights_reader.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/words/scene_words.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace kfast::scene {

namespace {

class ContentReader {
public:
    ContentReader(KeyHolder holder, const KeyDriver& driver, SceneContext& context)
        : holder_{holder},
          noun_{holder == KeyHolder::object ? "an object" : "a symbol"},
          context_{context},
          keys_{holder, driver, context}
    {
    }

    void read(const kdl::Node& node)
    {
        if (node.name == key_name)
            read_key(node);
        else if (is_drawn(node.name))
            read_drawn(node);
        else if (holder_ == KeyHolder::object && node.name == track_name)
            read_timed(node);
        else if (holder_ == KeyHolder::object && node.name == weights_name)
            read_weights(node);
        else if (holder_ == KeyHolder::symbol && is_item(node.name))
            report_mixed_kinds(node, context_);
        else
            report_unknown(node);
    }

    DrawingContent take()
    {
        content_.keys = keys_.take();
        return std::move(content_);
    }

private:
    void read_key(const kdl::Node& node)
    {
        const bool has_drawing = holds_drawing(node);
        if (has_drawing && !content_.drawn.empty())
            return report_mixture(node);
        has_drawing_keys_ = has_drawing_keys_ || has_drawing;
        content_.is_valid = keys_.read(node) && content_.is_valid;
    }

    void read_drawn(const kdl::Node& node)
    {
        if (has_drawing_keys_)
            return report_mixture(node);
        content_.drawn.push_back(&node);
    }

    void read_weights(const kdl::Node& node)
    {
        if (content_.weights == nullptr)
            content_.weights = &node;
        else
            context_.report.error(node.name_span, "this object has weights already, on " +
                                                      context_.report.line(content_.weights->name_span));
    }

    void read_timed(const kdl::Node& node)
    {
        if (auto quantity = read_track(node, holder_, context_))
            content_.timed.push_back(std::move(*quantity));
    }

    void report_mixture(const kdl::Node& node)
    {
        if (!std::exchange(is_mixed_, true))
            context_.report.error(
                node.name_span, std::string{noun_} + " has its drawings either in keys or without, not both",
                "put the shapes into a key: key 0 { … }");
    }

    void report_unknown(const kdl::Node& node)
    {
        if (node.name == skeleton_name)
            return report_skeleton(node);
        content_.is_valid =
            context_.report.error(node.name_span, std::string{noun_} + " has no node " + in_quotes(node.name),
                                  word_hint(node.name, names_in_drawing(holder_)));
    }

    void report_skeleton(const kdl::Node& node)
    {
        content_.is_valid = context_.report.error(node.name_span, "a skeleton stands in a key of an object",
                                                  "write key 0 { skeleton { … } }");
    }

    KeyHolder holder_;
    std::string_view noun_;
    SceneContext& context_;
    KeyList keys_;
    DrawingContent content_;
    bool has_drawing_keys_ = false;
    bool is_mixed_ = false; ///< has been reported
};

}

DrawingContent read_drawing_content(const kdl::Node& node, KeyHolder holder, const KeyDriver& driver,
                                    SceneContext& context)
{
    ContentReader content{holder, driver, context};
    for (const kdl::Node& child : node.children)
        if (!context.report.full())
            content.read(child);
    return content.take();
}

std::vector<std::string_view> names_in_drawing(KeyHolder holder)
{
    std::vector<std::string_view> names = drawn_names();
    names.insert(names.begin(), key_name);
    if (holder == KeyHolder::object) {
        names.insert(names.begin() + 1, track_name);
        names.push_back(weights_name);
    }
    return names;
}

namespace {

bool is_flat(const Key& key) { return !key.drawing.strokes.empty() && key.depths.strokes.empty(); }

}

bool is_wire_frame(const std::vector<Key>& keys)
{
    return std::ranges::any_of(keys, [](const Key& key) { return !key.depths.strokes.empty(); });
}

void refuse_mixed_depths(const std::vector<Key>& keys, SceneContext& context)
{
    const auto flat = std::ranges::find_if(keys, is_flat);
    if (flat != keys.end() && is_wire_frame(keys))
        context.report.error(flat->place, "this drawing is flat, but another key has one with depth",
                             "draw it with wire, mesh or cuboid, or in an object of its own");
}

namespace {

void refuse_cuts_of_wires(const kdl::Node& object, const DrawingContent& content, SceneContext& context)
{
    const auto refuse = [&context](SourceSpan place, bool is_trim) {
        context.report.error(place,
                             std::string{"a drawing with depth is not "} + (is_trim ? "trimmed" : "dashed"),
                             "draw it without depth");
    };
    for (std::size_t i = 0; i < property_count; ++i) {
        const auto property = static_cast<Property>(i);
        const std::string_view name = property_name(property);
        if (!is_of_trim(property) && property != Property::dash_offset && property != Property::dash_1)
            continue;
        if (has_property(object, name))
            refuse(property_span(object, name), is_of_trim(property));
        for (const ItemKey& key : content.keys)
            if (key.values.get(property))
                refuse(property_span(*key.node, name), is_of_trim(property));
        for (const TimedQuantity& quantity : content.timed)
            if (gives(quantity, property))
                refuse(quantity.place, is_of_trim(property));
    }
}

}

void refuse_beside_wires(const kdl::Node& object, const DrawingContent& content, const std::vector<Key>& keys,
                         SceneContext& context)
{
    const auto refuse = [&context](SourceSpan place, std::string_view what, std::string hint) {
        context.report.error(place, "a drawing with depth has no " + std::string{what}, std::move(hint));
    };
    if (has_property(object, "fill"))
        refuse(property_span(object, "fill"), "fill", "use stroke=COLOUR alone");
    for (const std::string_view property : {"skin", "bone", "bones"})
        if (has_property(object, property))
            refuse(property_span(object, property), property, "turn the object, or a group around it");
    if (content.weights != nullptr && !has_property(object, "skin"))
        refuse(content.weights->name_span, "weights", "remove them");
    const auto deformed =
        std::ranges::find_if(content.keys, [](const ItemKey& key) { return key.skeleton != nullptr; });
    if (deformed != content.keys.end())
        refuse(deformed->skeleton->name_span, "skeleton", "turn the object, or a group around it");
    refuse_cuts_of_wires(object, content, context);
    const auto matched = std::ranges::find_if(keys, [](const Key& key) { return key.match != Match::count; });
    if (matched != keys.end())
        context.report.error(matched->place,
                             "match=" + std::string{match_name(matched->match)} + " does not work with depth",
                             "use match=count");
}

}
