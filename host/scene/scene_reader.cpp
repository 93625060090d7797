#include "host/scene/scene_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/input_reader.hpp"
#include "host/scene/items/item_reader.hpp"
#include "host/scene/items/object_properties.hpp"
#include "host/scene/items/object_reader.hpp"
#include "host/scene/items/symbol_instances.hpp"
#include "host/scene/items/symbol_reader.hpp"
#include "host/scene/items/symbol_use.hpp"
#include "host/scene/shapes/shape_reader.hpp"
#include "host/scene/shapes/wire_reader.hpp"
#include "host/scene/skeleton/bones_reader.hpp"
#include "host/scene/values/canvas_reader.hpp"
#include "host/scene/values/clips_and_events.hpp"
#include "host/scene/values/let_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/report.hpp"
#include "host/text/characters.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::scene {
namespace {

constexpr int language_version = 1;
constexpr NodeForm version_form{"kfast", "kfast 1", 1, 1};

/// The nodes of the outermost level. Only `kfast` has a fixed position; what the others need from each other
/// is read first.
struct Parts {
    const kdl::Node* version = nullptr;
    const kdl::Node* canvas = nullptr;
    const kdl::Node* palette = nullptr;
    std::vector<const kdl::Node*> variables;
    std::vector<const kdl::Node*> inputs;
    std::vector<const kdl::Node*> skeletons;
    std::vector<const kdl::Node*> symbols;
    std::vector<const kdl::Node*> items;
    std::vector<const kdl::Node*> clips;
    std::vector<const kdl::Node*> events;
};

template <const kdl::Node* Parts::*part>
void take_single(Parts& parts, const kdl::Node& node, SceneContext& context)
{
    if (parts.*part == nullptr)
        parts.*part = &node;
    else
        context.report.error(node.name_span, "there is a " + node.name + " already, on " +
                                                 context.report.line((parts.*part)->name_span));
}

template <std::vector<const kdl::Node*> Parts::*list>
void take_each(Parts& parts, const kdl::Node& node, SceneContext&)
{
    (parts.*list).push_back(&node);
}

struct PartRule {
    std::string_view name;
    void (*take)(Parts& parts, const kdl::Node& node, SceneContext& context);
};

constexpr std::array part_rules{
    PartRule{"kfast", take_single<&Parts::version>},   PartRule{"canvas", take_single<&Parts::canvas>},
    PartRule{"palette", take_single<&Parts::palette>}, PartRule{symbol_name, take_each<&Parts::symbols>},
    PartRule{object_name, take_each<&Parts::items>},   PartRule{group_name, take_each<&Parts::items>},
    PartRule{use_name, take_each<&Parts::items>},      PartRule{bones_name, take_each<&Parts::skeletons>},
    PartRule{"clip", take_each<&Parts::clips>},        PartRule{"event", take_each<&Parts::events>},
    PartRule{input_name, take_each<&Parts::inputs>},   PartRule{let_name, take_each<&Parts::variables>},
};

void take_part(Parts& parts, const kdl::Node& node, SceneContext& context)
{
    const auto rule = std::ranges::find(part_rules, node.name, &PartRule::name);
    if (rule != part_rules.end())
        return rule->take(parts, node, context);
    context.report.error(node.name_span, "a scene has no node " + in_quotes(node.name),
                         word_hint(node.name, word_names<part_rules>));
}

Parts sort_out(const kdl::Document& document, SceneContext& context)
{
    Parts parts;
    for (const kdl::Node& node : document.nodes)
        if (!context.report.full())
            take_part(parts, node, context);
    return parts;
}

/// Whether this program supports the version of the text.
bool read_version(const kdl::Node& node, SceneContext& context)
{
    if (!fits(node, version_form, context.report) || !refuse_properties(node, context.report))
        return true;
    const kdl::Value& value = node.arguments.front();
    const auto version = read_whole_number(value, {1, 1e9}, context.report);
    if (!version || *version == language_version)
        return true;
    return context.report.error(value.place, "this scene needs a newer kfast",
                                "this one reads version " + std::to_string(language_version) +
                                    " of the scene language");
}

bool read_version(const kdl::Document& document, SceneContext& context)
{
    if (!document.nodes.empty() && document.nodes.front().name == version_form.name)
        return read_version(document.nodes.front(), context);
    const SourceSpan place = document.nodes.empty() ? SourceSpan{} : document.nodes.front().name_span;
    context.report.error(place, "a scene begins with the version of its language",
                         "write \"kfast 1\" in front of everything else");
    return true;
}

/// The property of an object that is written at one of its shapes, which is a common mistake.
std::string_view property_of_object(const kdl::Node& node, const kdl::Property& property)
{
    static const auto names = [] {
        std::vector<std::string_view> list;
        std::ranges::transform(object_property_schema(), std::back_inserter(list), &PropertySchema::name);
        return list;
    }();
    return is_shape(node.name) || is_wire(node.name) ? meaning_among(names, property.name)
                                                     : std::string_view{};
}

/// Where a property is that stands at a wrong node.
std::string hint_of_place(const kdl::Node& node, const kdl::Property& property,
                          std::span<const std::string_view> known)
{
    constexpr std::array<std::string_view, 1> of_symbol{"frames"};
    if (node.name == use_name && !meaning_among(of_symbol, property.name).empty())
        return "the symbol has it: symbol NAME frames=…";
    const std::string_view of_object = property_of_object(node, property);
    if (of_object.empty() || !meaning_among(known, property.name).empty())
        return {};
    return "objects have it: object NAME " + std::string{of_object} + "=…";
}

void read_canvas(const kdl::Document& document, const Parts& parts, Scene& scene, SceneContext& context)
{
    if (parts.canvas != nullptr)
        return read_canvas(*parts.canvas, scene, context);
    const SourceSpan place = document.nodes.empty() ? SourceSpan{} : document.nodes.front().name_span;
    context.report.error(place, "this scene has no canvas", "add \"canvas 240 240\"");
}

void read_inputs(const Parts& parts, SceneContext& context)
{
    for (const kdl::Node* node : parts.inputs)
        if (!context.report.full())
            add_input(*node, context);
}

void take_inputs(Scene& scene, SceneContext& context)
{
    warn_of_unused_inputs(context);
    for (InputEntry& entry : context.inputs.entries)
        scene.inputs.push_back(std::move(entry.input));
}

void read_skeletons(const Parts& parts, SceneContext& context)
{
    for (const kdl::Node* node : parts.skeletons)
        if (!context.report.full())
            add_skeleton(*node, context);
}

void take_skeletons(Scene& scene, SceneContext& context)
{
    warn_of_unused_skeletons(context);
    for (Skeleton& skeleton : context.skeletons.entries)
        scene.bones.push_back(std::move(skeleton.bones));
}

void read_items(const Parts& parts, Scene& scene, SceneContext& context)
{
    for (const kdl::Node* node : parts.symbols)
        if (!context.report.full())
            add_symbol(*node, context);
    for (const kdl::Node* node : parts.items)
        if (!context.report.full())
            read_item(*node, 0, scene.items, context);
    refuse_crowded_order(scene.items, context);
}

void read_marks(const Parts& parts, Scene& scene, SceneContext& context)
{
    NameTable clip_names;
    for (const kdl::Node* node : parts.clips)
        if (!context.report.full())
            if (auto clip = read_clip(*node, scene.length, clip_names, context))
                scene.clips.push_back(std::move(*clip));
    for (const kdl::Node* node : parts.events)
        if (!context.report.full())
            if (auto event = read_event(*node, scene, context))
                scene.events.push_back(std::move(*event));
    std::ranges::stable_sort(scene.events, {}, &Event::time);
}

}

std::optional<Scene> read_scene(const kdl::Document& document, const SourceText& source,
                                Diagnostics& diagnostics)
{
    SceneContext context{
        .report = {source, diagnostics, hint_of_place}, .palette = {}, .fonts = FontShelf{source.folder}};
    if (!read_version(document, context))
        return std::nullopt;
    const Parts parts = sort_out(document, context);
    if (parts.palette != nullptr)
        read_palette(*parts.palette, context);
    read_variables(parts.variables, context);
    Scene scene;
    read_canvas(document, parts, scene, context);
    read_inputs(parts, context);
    read_skeletons(parts, context);
    read_items(parts, scene, context);
    scene.length = context.length.value_or(std::max(context.last_key, Time::frame(1)));
    read_marks(parts, scene, context);
    scene.palette = context.palette.used();
    // After everything that uses what has been read: what they hold is not part of the scene.
    check_unused_symbols(context);
    warn_of_late_keys(context);
    take_inputs(scene, context);
    take_skeletons(scene, context);
    if (!diagnostics.has_errors()) { // else what uses them may not have been read
        warn_of_unused_variables(context);
        add_symbol_instances(scene, context);
    }
    if (diagnostics.has_errors())
        return std::nullopt;
    return scene;
}

NodeSchema version_schema()
{
    return {version_form.name, version_form, {ValueKind::whole({language_version, language_version})}};
}

std::span<const std::string_view> names_outermost() { return word_names<part_rules>; }

}
