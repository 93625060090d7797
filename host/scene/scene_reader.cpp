#include "host/scene/scene_reader.hpp"

#include "host/scene/bones_reader.hpp"
#include "host/scene/canvas_reader.hpp"
#include "host/scene/clip_reader.hpp"
#include "host/scene/event_reader.hpp"
#include "host/scene/group_reader.hpp"
#include "host/scene/input_reader.hpp"
#include "host/scene/item_reader.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/name_table.hpp"
#include "host/scene/node_form.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/object_reader.hpp"
#include "host/scene/palette_reader.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/reading.hpp"
#include "host/scene/symbol_reader.hpp"
#include "host/scene/symbol_use.hpp"
#include "host/scene/synonyms.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

constexpr int language_version = 1;
constexpr NodeForm version_form{"kfast", "kfast 1", 1, 1};

/// The nodes of the outermost level. Only `kfast` has a fixed place; what the others need of each other is
/// read first.
struct Parts {
    const kdl::Node* version = nullptr;
    const kdl::Node* canvas = nullptr;
    const kdl::Node* palette = nullptr;
    std::vector<const kdl::Node*> inputs;
    std::vector<const kdl::Node*> skeletons;
    std::vector<const kdl::Node*> symbols;
    std::vector<const kdl::Node*> items;
    std::vector<const kdl::Node*> clips;
    std::vector<const kdl::Node*> events;
};

template <const kdl::Node* Parts::*part>
void take_single(Parts& parts, const kdl::Node& node, Reading& reading)
{
    if (parts.*part == nullptr)
        parts.*part = &node;
    else
        reading.report.error(node.name_place, "there is a " + node.name + " already, on " +
                                                  reading.report.line((parts.*part)->name_place));
}

template <std::vector<const kdl::Node*> Parts::*list>
void take_each(Parts& parts, const kdl::Node& node, Reading&)
{
    (parts.*list).push_back(&node);
}

struct PartRule {
    std::string_view name;
    void (*take)(Parts& parts, const kdl::Node& node, Reading& reading);
};

constexpr std::array part_rules{
    PartRule{"kfast", take_single<&Parts::version>},   PartRule{"canvas", take_single<&Parts::canvas>},
    PartRule{"palette", take_single<&Parts::palette>}, PartRule{symbol_name, take_each<&Parts::symbols>},
    PartRule{object_name, take_each<&Parts::items>},   PartRule{group_name, take_each<&Parts::items>},
    PartRule{use_name, take_each<&Parts::items>},      PartRule{bones_name, take_each<&Parts::skeletons>},
    PartRule{"clip", take_each<&Parts::clips>},        PartRule{"event", take_each<&Parts::events>},
    PartRule{input_name, take_each<&Parts::inputs>},
};

void take_part(Parts& parts, const kdl::Node& node, Reading& reading)
{
    const auto rule = std::ranges::find(part_rules, node.name, &PartRule::name);
    if (rule != part_rules.end())
        return rule->take(parts, node, reading);
    reading.report.error(node.name_place, "a scene has no node " + in_quotes(node.name),
                         word_remedy(node.name, word_names<part_rules>));
}

Parts sort_out(const kdl::Document& document, Reading& reading)
{
    Parts parts;
    for (const kdl::Node& node : document.nodes)
        if (!reading.report.full())
            take_part(parts, node, reading);
    return parts;
}

/// Whether this program can know what the rest means.
bool read_version(const kdl::Node& node, Reading& reading)
{
    if (!fits(node, version_form, reading) || !refuse_properties(node, reading))
        return true;
    const kdl::Value& value = node.arguments.front();
    const auto version = read_whole_number(value, {1, 1e9}, reading);
    if (!version || *version == language_version)
        return true;
    return reading.report.error(value.place, "this scene needs a newer kfast",
                                "this one reads version " + std::to_string(language_version) +
                                    " of the scene language");
}

bool read_version(const kdl::Document& document, Reading& reading)
{
    if (!document.nodes.empty() && document.nodes.front().name == version_form.name)
        return read_version(document.nodes.front(), reading);
    const Place place = document.nodes.empty() ? Place{} : document.nodes.front().name_place;
    reading.report.error(place, "a scene begins with the version of its language",
                         "write \"kfast 1\" in front of everything else");
    return true;
}

void read_canvas(const kdl::Document& document, const Parts& parts, Scene& scene, Reading& reading)
{
    if (parts.canvas != nullptr)
        return read_canvas(*parts.canvas, scene, reading);
    const Place place = document.nodes.empty() ? Place{} : document.nodes.front().name_place;
    reading.report.error(place, "this scene has no canvas", "add \"canvas 240 240\"");
}

void read_inputs(const Parts& parts, Reading& reading)
{
    for (const kdl::Node* node : parts.inputs)
        if (!reading.report.full())
            add_input(*node, reading);
}

void take_inputs(Scene& scene, Reading& reading)
{
    warn_of_unused_inputs(reading);
    for (InputEntry& entry : reading.inputs.entries)
        scene.inputs.push_back(std::move(entry.input));
}

void read_skeletons(const Parts& parts, Reading& reading)
{
    for (const kdl::Node* node : parts.skeletons)
        if (!reading.report.full())
            add_skeleton(*node, reading);
}

void take_skeletons(Scene& scene, Reading& reading)
{
    warn_of_unused_skeletons(reading);
    for (Skeleton& skeleton : reading.skeletons.entries)
        scene.bones.push_back(std::move(skeleton.bones));
}

void read_items(const Parts& parts, Scene& scene, Reading& reading)
{
    for (const kdl::Node* node : parts.symbols)
        if (!reading.report.full())
            add_symbol(*node, reading);
    for (const kdl::Node* node : parts.items)
        if (!reading.report.full())
            read_item(*node, 0, scene.items, reading);
    refuse_crowded_order(scene.items, reading);
}

void read_marks(const Parts& parts, Scene& scene, Reading& reading)
{
    NameTable clip_names;
    for (const kdl::Node* node : parts.clips)
        if (!reading.report.full())
            if (auto clip = read_clip(*node, scene.length, clip_names, reading))
                scene.clips.push_back(std::move(*clip));
    for (const kdl::Node* node : parts.events)
        if (!reading.report.full())
            if (auto event = read_event(*node, scene, reading))
                scene.events.push_back(std::move(*event));
    std::ranges::stable_sort(scene.events, {}, &Event::time);
}

}

std::optional<Scene> read_scene(const kdl::Document& document, const SourceText& source,
                                Diagnostics& diagnostics)
{
    Reading reading{.report = {source, diagnostics}, .palette = {}, .fonts = FontShelf{source.folder}};
    if (!read_version(document, reading))
        return std::nullopt;
    const Parts parts = sort_out(document, reading);
    if (parts.palette != nullptr)
        read_palette(*parts.palette, reading);
    Scene scene;
    read_canvas(document, parts, scene, reading);
    read_inputs(parts, reading);
    read_skeletons(parts, reading);
    read_items(parts, scene, reading);
    scene.length = reading.length.value_or(std::max(reading.last_key, Time::frame(1)));
    read_marks(parts, scene, reading);
    scene.palette = reading.palette.used();
    // Behind all that asks what has been read: what they hold is not part of the scene.
    check_unused_symbols(reading);
    take_inputs(scene, reading);
    take_skeletons(scene, reading);
    if (!diagnostics.has_errors())
        move_symbols(scene, reading);
    if (diagnostics.has_errors())
        return std::nullopt;
    return scene;
}

NodeWords version_words()
{
    return {version_form.name, version_form, {ValueKind::whole({language_version, language_version})}};
}

std::span<const std::string_view> names_outermost() { return word_names<part_rules>; }

}
