#include "host/scene/items/track_reader.hpp"

#include "host/scene/values/geometry_reader.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/scene/values/law_reader.hpp"
#include "host/scene/values/timed_quantity.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/words/scene_words.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

constexpr NodeForm track_form{track_name, "track QUANTITY { at TIME VALUE }", 1, 1, true};
constexpr NodeForm along_form{track_name, "track along \"M …\" { at TIME SHARE }", 2, 2, true};

/// What a track moves.
struct Quantity {
    std::string_view name;
    Property property;
    std::optional<Property> other = std::nullopt; ///< moved as well
};

constexpr Quantity same_name(Property property) { return {property_name(property), property}; }

constexpr std::array quantities{
    same_name(Property::x),
    same_name(Property::y),
    same_name(Property::z),
    same_name(Property::rotation),
    same_name(Property::rotation_x),
    same_name(Property::rotation_y),
    Quantity{"rotate-z", Property::rotation},
    Quantity{"scale", Property::scale_x, Property::scale_y},
    same_name(Property::scale_x),
    same_name(Property::scale_y),
    same_name(Property::pivot_x),
    same_name(Property::pivot_y),
    same_name(Property::opacity),
    same_name(Property::along),
    // Only objects have the rest.
    same_name(Property::width),
    same_name(Property::trim_from),
    same_name(Property::trim_to),
    same_name(Property::trim_offset),
    same_name(Property::dash_offset),
};
constexpr std::size_t of_objects = 5;

constexpr bool is_of_objects(Property property) { return property >= Property::width; }

constexpr std::array keys_only{Property::order, Property::visible, Property::fill, Property::stroke,
                               Property::dash_1};

void report_unknown_quantity(const kdl::Value& value, std::string_view name, KeyHolder holder,
                             SceneContext& context)
{
    const std::string text{name};
    if (std::ranges::find(keys_only, name, property_name) != keys_only.end())
        context.report.error(value.place, text + " has no track by key times",
                             "set it in keys: key 0 " + text + "=…");
    else if (std::ranges::find(quantities, name, &Quantity::name) != quantities.end())
        context.report.error(value.place, "only objects have " + in_quotes(name),
                             "let the track stand in an object");
    else {
        const std::size_t hidden = holder == KeyHolder::object ? 0 : of_objects;
        const std::span known{word_names<quantities>};
        context.report.error(value.place, "unknown quantity " + in_quotes(name),
                             word_hint(name, known.first(known.size() - hidden)));
    }
}

const Quantity* read_quantity(const kdl::Value& value, KeyHolder holder, SceneContext& context)
{
    const auto name = read_text(value, context.report);
    if (!name)
        return nullptr;
    const auto found = std::ranges::find(quantities, *name, &Quantity::name);
    const bool is_known =
        found != quantities.end() && (!is_of_objects(found->property) || holder == KeyHolder::object);
    if (is_known)
        return &*found;
    report_unknown_quantity(value, *name, holder, context);
    return nullptr;
}

/// The properties of a node `track`.
struct TrackProperties {
    std::optional<VelocityLaw> law; ///< none: the track is smooth
    bool turns = false;
    KeyDriver driver;
};

bool read_law_of_track(const kdl::Value& value, TrackProperties& track, SceneContext& context)
{
    return assign(read_law(value, context.report), track.law);
}

bool read_turn(const kdl::Value& value, TrackProperties& track, SceneContext& context)
{
    return assign(read_flag(value, context.report), track.turns);
}

constexpr std::array track_rules{
    PropertyRule<TrackProperties>{"law", read_law_of_track, any_law},
    PropertyRule<TrackProperties>{"input", read_own_driver<TrackProperties>, any_name}};
constexpr auto along_rules =
    joined(track_rules, std::array{PropertyRule<TrackProperties>{"turn", read_turn, truth}});

class TrackReader {
public:
    TrackReader(const kdl::Node& node, const Quantity& quantity, SceneContext& context)
        : node_{node}, quantity_{quantity}, context_{context}
    {
    }

    TimedQuantity read()
    {
        TimedQuantity result{.name = quantity_.name,
                             .place = span(node_.name_span, node_.arguments.front().place),
                             .tracks = {},
                             .path = {}};
        read_own();
        if (is_along() && node_.arguments.size() == 2)
            result.path = read_along_path(node_.arguments.back(), context_);
        if (result.path)
            result.path->turns = properties_.turns;
        const std::vector<TrackKey> keys = read_keys(result.place);
        result.tracks.push_back(track_of(quantity_.property, keys));
        if (quantity_.other)
            result.tracks.push_back(track_of(*quantity_.other, keys));
        return result;
    }

private:
    bool is_along() const { return quantity_.property == Property::along; }

    void read_own()
    {
        fits(node_, is_along() ? along_form : track_form, context_.report);
        if (is_along()) {
            properties_.law = VelocityLaw::constant;
            read_properties(node_, along_rules, properties_, context_);
        } else {
            read_properties(node_, track_rules, properties_, context_);
        }
    }

    std::vector<TrackKey> read_keys(SourceSpan place)
    {
        const std::vector<TimedValue> values =
            read_timed_values(node_, quantity_.property, properties_.driver, context_);
        if (node_.children.empty())
            context_.report.error(place, "this track has no values", "add { at 0 …; at 30 … }");
        if (values.empty())
            return {};
        look_at_laws(values);
        std::vector<TrackKey> keys;
        keys.reserve(values.size());
        for (const TimedValue& timed : values)
            keys.push_back({timed.time, laws_of(timed), timed.value, timed.place});
        keys.back().laws = {};
        // The slope of a smooth track at a key depends on the key after it.
        if (properties_.driver.is_time())
            take_times(keys, properties_.law ? 1 : 2, "value", context_);
        return keys;
    }

    LawPair laws_of(const TimedValue& timed) const
    {
        if (!properties_.law)
            return {};
        const VelocityLaw law = timed.law.value_or(*properties_.law);
        return {law, law};
    }

    void look_at_laws(const std::vector<TimedValue>& values)
    {
        for (const TimedValue& timed : values)
            if (timed.law && !properties_.law)
                context_.report.error(property_span(*timed.node, "law"),
                                      "this track is smooth: it goes by no laws",
                                      "write track " + std::string{quantity_.name} + " law=constant");
        if (values.back().law)
            warn_of_idle_law(*values.back().node);
        if (values.size() == 1 && has_property(node_, "law"))
            warn_of_idle_law(node_);
    }

    void warn_of_idle_law(const kdl::Node& node)
    {
        context_.report.warning(property_span(node, "law"), "this law governs nothing",
                                "remove it, or add a later value");
    }

    Track track_of(Property property, const std::vector<TrackKey>& keys) const
    {
        return {property, keys, !properties_.law.has_value(), properties_.driver.driver()};
    }

    const kdl::Node& node_;
    const Quantity& quantity_;
    SceneContext& context_;
    TrackProperties properties_;
};

}

std::optional<TimedQuantity> read_track(const kdl::Node& node, KeyHolder holder, SceneContext& context)
{
    if (node.arguments.empty()) {
        fits(node, track_form, context.report);
        return std::nullopt;
    }
    const Quantity* const quantity = read_quantity(node.arguments.front(), holder, context);
    if (quantity == nullptr)
        return std::nullopt;
    return TrackReader{node, *quantity, context}.read();
}

std::vector<NodeSchema> track_schema()
{
    constexpr ValueKind quantity = ValueKind::one_of<quantities>();
    constexpr std::size_t along = 1;
    const auto name = std::ranges::find(quantities, Property::along, &Quantity::property);
    const auto place = static_cast<std::size_t>(name - quantities.begin());
    ValueKind path = quantity;
    path.words = quantity.words.subspan(place, along);
    return {{track_name, track_form, {quantity}, schema_of(track_rules), {at_name}},
            {track_name, along_form, {path, any_path}, schema_of(along_rules), {at_name}}};
}

std::vector<PropertySchema> quantity_schema()
{
    std::vector<PropertySchema> words;
    words.reserve(std::size(quantities));
    for (const Quantity& quantity : quantities)
        words.push_back({quantity.name, kind_of(quantity.property)});
    return words;
}

}
