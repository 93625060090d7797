#include "host/synfig/evaluation/value_reader.hpp"

#include "host/synfig/evaluation/evaluator.hpp"
#include "host/synfig/values/constant_reader.hpp"

#include <algorithm>

namespace kfast::synfig {
namespace {

constexpr int deepest_value = 120;
// Values with an id may be nested to any depth, though none is read within another.
constexpr int deepest_formula = 400;

bool is_list(std::string_view kind)
{
    return kind == "static_list" || kind == "dynamic_list" || kind == "bline" || kind == "wplist" ||
           kind == "dilist" || kind == "average" || kind == "weighted_average";
}

void collect_unknown(ValueNode& node)
{
    constexpr std::size_t max = 8;
    const auto add = [&node](const std::set<std::string>& kinds) {
        for (const std::string& kind : kinds)
            if (node.unknown.size() < max)
                node.unknown.insert(kind);
    };
    if (!Evaluator::knows(node.kind))
        node.unknown.insert(node.kind);
    for (const Waypoint& point : node.waypoints)
        if (point.value)
            add(point.value->unknown);
    for (const Entry& entry : node.entries)
        add(entry.value->unknown);
    for (const auto& [name, link] : node.links)
        add(link->unknown);
}

/// Files of old versions number the parts of composites from "c1" on, and of radial ones from "c0" on.
std::string_view current_link(const ValueNode& node, std::string_view name)
{
    using Parts = std::vector<std::string_view>;
    static const std::map<std::string_view, Parts> composites{
        {"vector", {"x", "y"}},
        {"color", {"r", "g", "b", "a"}},
        {"segment", {"p1", "t1", "p2", "t2"}},
        {"bline_point", {"point", "width", "origin", "split", "t1", "t2"}}};
    static const std::map<std::string_view, Parts> radial{
        {"vector", {"radius", "theta"}}, {"color", {"y_luma", "saturation", "hue", "alpha"}}};
    if (name.size() != 2 || name[0] != 'c' || (node.kind != "composite" && node.kind != "radial_composite"))
        return name;
    const bool is_radial = node.kind == "radial_composite";
    const auto& known = is_radial ? radial : composites;
    const auto parts = known.find(node.type);
    const auto index = static_cast<std::size_t>(name[1] - (is_radial ? '0' : '1'));
    return parts == known.end() || index >= parts->second.size() ? name : parts->second[index];
}

int depth_below(const ValueNode& node)
{
    int deepest = 0;
    const auto look_at = [&](const ValueNode& inner) { deepest = std::max(deepest, inner.depth + 1); };
    for (const auto& [name, link] : node.links)
        look_at(*link);
    for (const Waypoint& point : node.waypoints)
        look_at(*point.value);
    for (const Entry& entry : node.entries)
        look_at(*entry.value);
    return deepest;
}

bool is_guid_reference(pugi::xml_node element) { return element.attribute("guid") && !element.first_child(); }

}

ValueNodePtr ValueReader::read_inside(pugi::xml_node holder)
{
    if (const auto use = holder.attribute("use"))
        return with_id(use.value(), XmlFile::place(holder));
    const pugi::xml_node element = XmlFile::first_element(holder);
    return element ? read(element) : nullptr;
}

ValueNodePtr ValueReader::with_id(std::string_view id, std::size_t place)
{
    if (const pugi::xml_node element = file_.value_with_id(id))
        return read(element);
    if (!XmlFile::is_of_another_file(id))
        file_.fail(place, "there is no value with the id \"" + std::string{id} + '"');
    losses_.add(
        {"value \"" + std::string{id} + "\" of another file", "", {}, "the usual value, such as black"});
    auto nothing = std::make_shared<ValueNode>();
    nothing->kind = "constant";
    nothing->place = place;
    return nothing;
}

ValueNodePtr ValueReader::bone(std::string_view guid)
{
    const pugi::xml_node element = file_.with_guid(guid);
    return element && std::string_view{element.name()} == "bone" ? read(element) : nullptr;
}

ValueNodePtr ValueReader::read(pugi::xml_node element)
{
    if (is_guid_reference(element) && std::string_view{element.name()} != "bone_valuenode")
        if (const pugi::xml_node real = file_.with_guid(element.attribute("guid").value()))
            element = real;
    const std::size_t place = XmlFile::place(element);
    if (const auto found = known_.find(place); found != known_.end())
        return found->second;
    if (!begun_.insert(place).second)
        file_.fail(place, "this value contains itself");
    if (++depth_ > deepest_value)
        file_.fail(place, "values lie more than " + std::to_string(deepest_value) + " deep in each other");
    ValueNodePtr node = read_new(element);
    --depth_;
    known_.emplace(place, node);
    return node;
}

ValueNodePtr ValueReader::read_new(pugi::xml_node element)
{
    auto node = std::make_shared<ValueNode>();
    node->kind = element.name();
    node->type = element.attribute("type").value();
    node->place = XmlFile::place(element);
    node->loop = ConstantReader::is_true(element.attribute("loop"));
    if (ConstantReader::knows(node->kind)) {
        node->type = node->kind;
        node->kind = "constant";
        node->constant = constants_.read(element);
    } else if (node->kind == "animated" || node->kind == "hermite") {
        node->kind = "animated";
        read_waypoints(element, *node);
    } else if (is_list(node->kind)) {
        read_entries(element, *node);
    } else {
        if (node->kind == "bone")
            node->constant.held = BoneName{element.attribute("guid").value()};
        read_links(element, *node);
    }
    collect_unknown(*node);
    node->depth = depth_below(*node);
    if (node->depth > deepest_formula)
        file_.fail(node->place, "this value is made of too many others one after the other");
    return node;
}

void ValueReader::read_waypoints(pugi::xml_node element, ValueNode& node)
{
    for (const pugi::xml_node child : element.children("waypoint"))
        if (Waypoint point = waypoint(child, node.type); point.value)
            node.waypoints.push_back(std::move(point));
    std::ranges::stable_sort(node.waypoints, {}, &Waypoint::time);
    const auto at_one_time = [](const Waypoint& left, const Waypoint& right) {
        return left.time == right.time;
    };
    node.waypoints.erase(std::unique(node.waypoints.begin(), node.waypoints.end(), at_one_time),
                         node.waypoints.end());
    if (node.waypoints.empty())
        file_.fail(node.place, "this animation has no waypoint");
}

Waypoint ValueReader::waypoint(pugi::xml_node element, const std::string& type)
{
    Waypoint point;
    point.time = constants_.time(element, "time");
    if (type != "canvas")
        point.value = read_inside(element);
    const auto default_value = type == "angle" ? Interpolation::linear : Interpolation::automatic;
    point.before = interpolation(element.attribute("before"), default_value);
    point.after = interpolation(element.attribute("after"), default_value);
    point.tension = constants_.number(element, "tension", 0);
    point.continuity = constants_.number(element, "continuity", 0);
    point.bias = constants_.number(element, "bias", 0);
    point.temporal_tension = constants_.number(element, "temporal-tension", 0);
    return point;
}

Interpolation ValueReader::interpolation(pugi::xml_attribute attribute, Interpolation default_value) const
{
    static constexpr std::pair<std::string_view, Interpolation> names[] = {
        {"auto", Interpolation::automatic},
        {"constant", Interpolation::constant},
        {"linear", Interpolation::linear},
        {"halt", Interpolation::halt},
        {"clamped", Interpolation::clamped}};
    if (!attribute)
        return default_value;
    for (const auto& [name, kind] : names)
        if (attribute.value() == name)
            return kind;
    losses_.add({std::string{"interpolation \""} + attribute.value() + '"', "", {}, "the usual one"});
    return default_value;
}

void ValueReader::read_entries(pugi::xml_node element, ValueNode& node)
{
    for (const pugi::xml_node child : element.children("entry")) {
        Entry entry;
        entry.value = read_inside(child);
        if (!entry.value)
            file_.fail(XmlFile::place(child), "this entry has no value");
        for (const char* name : {"begin", "on"})
            read_switchings(child.attribute(name), true, entry);
        for (const char* name : {"end", "off"})
            read_switchings(child.attribute(name), false, entry);
        std::ranges::stable_sort(entry.switchings, {}, &Switching::time);
        node.entries.push_back(std::move(entry));
    }
}

/// "1s, p2 3s": times, each perhaps with a priority in front.
void ValueReader::read_switchings(pugi::xml_attribute times, bool on, Entry& entry)
{
    std::string_view rest = times.value();
    while (!rest.empty()) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        std::string_view one = rest.substr(0, comma);
        rest.remove_prefix(std::min(comma + 1, rest.size()));
        one.remove_prefix(std::min(one.find_first_not_of(" \t\r\n"), one.size()));
        if (one.starts_with('p'))
            one.remove_prefix(std::min(one.find(' '), one.size()));
        if (const auto moment = time_of(one, frame_rate_))
            entry.switchings.push_back({*moment, on});
    }
}

void ValueReader::read_links(pugi::xml_node element, ValueNode& node)
{
    for (const pugi::xml_attribute attribute : element.attributes()) {
        const std::string_view name = attribute.name();
        if (name != "guid" && name != "id" && name != "type" && name != "static" && name != "interpolation")
            node.links.emplace_back(current_link(node, name), with_id(attribute.value(), node.place));
    }
    for (const pugi::xml_node child : element.children())
        if (child.type() == pugi::node_element)
            if (ValueNodePtr value = read_inside(child))
                node.links.emplace_back(current_link(node, child.name()), std::move(value));
}

}
