#include "host/scene/scene_reader.hpp"

#include "host/scene/canvas_reader.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/node_form.hpp"
#include "host/scene/object_reader.hpp"
#include "host/scene/palette_reader.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/reading.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"

#include <unordered_map>

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
    std::vector<const kdl::Node*> objects;
};

void take_once(const kdl::Node*& part, const kdl::Node& node, Reading& reading)
{
    if (part == nullptr)
        part = &node;
    else
        reading.report.error(node.name_place, "there is a " + node.name + " already, on " +
                                                  reading.report.line(part->name_place));
}

template <const kdl::Node* Parts::*part>
void take_single(Parts& parts, const kdl::Node& node, Reading& reading)
{
    take_once(parts.*part, node, reading);
}

void take_object(Parts& parts, const kdl::Node& node, Reading& reading)
{
    if (parts.objects.size() < most_objects)
        parts.objects.push_back(&node);
    else
        reading.report.error(node.name_place,
                             "a scene holds at most " + std::to_string(most_objects) + " objects");
}

struct PartRule {
    std::string_view name;
    void (*take)(Parts& parts, const kdl::Node& node, Reading& reading);
};

constexpr std::array part_rules{
    PartRule{"kfast", take_single<&Parts::version>},
    PartRule{"canvas", take_single<&Parts::canvas>},
    PartRule{"palette", take_single<&Parts::palette>},
    PartRule{"object", take_object},
};

void take_part(Parts& parts, const kdl::Node& node, Reading& reading)
{
    const auto rule = std::ranges::find(part_rules, node.name, &PartRule::name);
    if (rule != part_rules.end())
        return rule->take(parts, node, reading);
    std::array<std::string_view, part_rules.size()> known;
    std::ranges::transform(part_rules, known.begin(), &PartRule::name);
    reading.report.error(node.name_place, "a scene has no node " + quoted(node.name),
                         suggestion(node.name, known));
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

std::optional<Time> read_canvas(const kdl::Document& document, const Parts& parts, Scene& scene,
                                Reading& reading)
{
    if (parts.canvas != nullptr)
        return read_canvas(*parts.canvas, scene, reading);
    const Place place = document.nodes.empty() ? Place{} : document.nodes.front().name_place;
    reading.report.error(place, "this scene has no canvas", "add \"canvas 240 240\"");
    return std::nullopt;
}

void read_objects(const Parts& parts, Scene& scene, Reading& reading)
{
    std::unordered_map<std::string, Place> names;
    for (const kdl::Node* node : parts.objects) {
        if (reading.report.full())
            return;
        auto object = read_object(*node, reading);
        if (!object)
            continue;
        const auto [entry, fresh] = names.try_emplace(object->name, object->place);
        if (!fresh)
            reading.report.error(object->place, "there is an object " + quoted(object->name) +
                                                    " already, on " + reading.report.line(entry->second));
        scene.objects.push_back(std::move(*object));
    }
}

/// The time of the last key, but one frame at least.
Time natural_length(const Scene& scene)
{
    Time length = Time::frame(1);
    for (const Object& object : scene.objects)
        if (!object.keys.empty())
            length = std::max(length, object.keys.back().time);
    return length;
}

/// The way to a key is seen in part if it begins before the end.
void warn_of_unseen_keys(const Scene& scene, Reading& reading)
{
    const auto begins_too_late = [&](const Key& key) { return key.time >= scene.length; };
    for (const Object& object : scene.objects) {
        const auto late = std::ranges::find_if(object.keys, begins_too_late);
        if (object.keys.end() - late > 1)
            reading.report.warning((late + 1)->place, "the scene ends before anything of this key is seen",
                                   "make the scene longer with frames=… or remove the key");
    }
}

}

std::optional<Scene> read_scene(const kdl::Document& document, const SourceText& source,
                                Diagnostics& diagnostics)
{
    Reading reading{.report = {source, diagnostics}, .palette = {}};
    if (!read_version(document, reading))
        return std::nullopt;
    const Parts parts = sort_out(document, reading);
    if (parts.palette != nullptr)
        read_palette(*parts.palette, reading);
    Scene scene;
    const auto length = read_canvas(document, parts, scene, reading);
    read_objects(parts, scene, reading);
    scene.length = length.value_or(natural_length(scene));
    warn_of_unseen_keys(scene, reading);
    scene.palette = reading.palette.used();
    if (diagnostics.has_errors())
        return std::nullopt;
    return scene;
}

}
