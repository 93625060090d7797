#include "host/scene/items/wire_rules.hpp"

#include "host/schema/property_rule.hpp"

#include <algorithm>
#include <string>

namespace kfast::scene {
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

void refuse_beside_wires(const kdl::Node& object, const DrawingContent& content, const std::vector<Key>& keys,
                         SceneContext& context)
{
    const auto refuse = [&context](SourceSpan place, std::string_view what, std::string hint) {
        context.report.error(place, "a drawing with depth has no " + std::string{what}, std::move(hint));
    };
    if (has_property(object, "fill"))
        refuse(property_span(object, "fill"), "fill", "use stroke=COLOUR alone");
    for (const std::string_view property : {"skin", "bone"})
        if (has_property(object, property))
            refuse(property_span(object, property), property, "turn the object, or a group around it");
    if (content.weights != nullptr && !has_property(object, "skin"))
        refuse(content.weights->name_span, "weights", "remove them");
    const auto deformed =
        std::ranges::find_if(content.keys, [](const ItemKey& key) { return key.skeleton != nullptr; });
    if (deformed != content.keys.end())
        refuse(deformed->skeleton->name_span, "skeleton", "turn the object, or a group around it");
    const auto matched =
        std::ranges::find_if(keys, [](const Key& key) { return key.match == Match::length; });
    if (matched != keys.end())
        context.report.error(matched->place, "match=length does not work with depth", "use match=count");
}

}
