#include "host/scene/items/object_properties.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/values/dash_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"

#include <cmath>
#include <string>
#include <string_view>

namespace kfast::scene {
namespace {

using Target = ObjectProperties;

constexpr std::array caps{Word<Cap>{"butt", Cap::butt}, Word<Cap>{"round", Cap::round},
                          Word<Cap>{"square", Cap::square}};
constexpr std::array joins{Word<Join>{"miter", Join::miter}, Word<Join>{"round", Join::round},
                           Word<Join>{"bevel", Join::bevel}};
constexpr std::array fill_rules{Word<FillRule>{"nonzero", FillRule::nonzero},
                                Word<FillRule>{"even-odd", FillRule::even_odd}};
constexpr Range widths{1.0 / 16, widest_stroke};
constexpr Range miters{1, 31};

/// Rounded once to 1/16 px, halves away from zero. A width of 0 is allowed only in keys.
bool read_width(const kdl::Value& value, Target& target, SceneContext& context)
{
    const auto width = read_number(value, widths, context.report);
    if (width)
        target.values[Property::width] = static_cast<std::int32_t>(std::lround(*width * 16));
    return width.has_value();
}

bool read_cap(const kdl::Value& value, Target& target, SceneContext& context)
{
    return assign(read_word(value, caps, context.report), target.stroke.cap);
}

bool read_join(const kdl::Value& value, Target& target, SceneContext& context)
{
    return assign(read_word(value, joins, context.report), target.stroke.join);
}

/// Rounded once to 1/8 width, halves away from zero.
bool read_miter(const kdl::Value& value, Target& target, SceneContext& context)
{
    const auto limit = read_number(value, miters, context.report);
    if (limit)
        target.stroke.miter_limit = static_cast<int>(std::lround(*limit * 8));
    return limit.has_value();
}

bool read_fill_rule(const kdl::Value& value, Target& target, SceneContext& context)
{
    return assign(read_word(value, fill_rules, context.report), target.fill_rule);
}

template <const kdl::Value* Target::*name>
bool keep_name(const kdl::Value& value, Target& target, SceneContext&)
{
    target.*name = &value;
    return true;
}

constexpr std::array style_rules{
    PropertyRule<Target>{"fill", read_own_value<Property::fill>, kind_of(Property::fill)},
    PropertyRule<Target>{"stroke", read_own_value<Property::stroke>, kind_of(Property::stroke)},
    PropertyRule<Target>{"width", read_width, ValueKind::pixels(widths), false, "stroke"},
    PropertyRule<Target>{"cap", read_cap, ValueKind::one_of<caps>(), false, "stroke"},
    PropertyRule<Target>{"join", read_join, ValueKind::one_of<joins>(), false, "stroke"},
    PropertyRule<Target>{"miter", read_miter, ValueKind::number(miters), false, "stroke"},
    PropertyRule<Target>{"rule", read_fill_rule, ValueKind::one_of<fill_rules>(), false, "fill"},
};

constexpr std::array beam_parts{
    Word<BeamParts>{"outline", BeamParts::outline}, Word<BeamParts>{"hatch", BeamParts::hatch},
    Word<BeamParts>{"both", BeamParts::both}, Word<BeamParts>{"none", BeamParts::none}};
constexpr Range hatch_spacings{kfb::min_hatch_spacing / 16.0, widest_stroke};
constexpr Range hatch_angles{-360, 360};

bool read_beam(const kdl::Value& value, Target& target, SceneContext& context)
{
    return assign(read_word(value, beam_parts, context.report), target.beam.parts);
}

/// Rounded once to 1/16 px, halves away from zero.
bool read_hatch(const kdl::Value& value, Target& target, SceneContext& context)
{
    const auto spacing = read_number(value, hatch_spacings, context.report);
    if (spacing)
        target.beam.spacing = static_cast<int>(std::lround(*spacing * 16));
    return spacing.has_value();
}

/// Rounded once to 1/65536 turn, halves away from zero.
bool read_hatch_angle(const kdl::Value& value, Target& target, SceneContext& context)
{
    const auto degrees = read_number(value, hatch_angles, context.report);
    if (degrees)
        target.beam.direction =
            BinaryAngle::from_raw(static_cast<std::int32_t>(std::lround(*degrees * BinaryAngle::turn / 360)));
    return degrees.has_value();
}

constexpr std::array beam_rules{
    PropertyRule<Target>{"beam", read_beam, ValueKind::one_of<beam_parts>()},
    PropertyRule<Target>{"hatch", read_hatch, ValueKind::pixels(hatch_spacings)},
    PropertyRule<Target>{"hatch-angle", read_hatch_angle, ValueKind::degrees(hatch_angles)},
};

void check_beam(const kdl::Node& node, const BeamStyle& style, SceneContext& context)
{
    if (style.has_hatching() && !has_property(node, "fill"))
        context.report.error(property_span(node, "beam"), "this object has no fill to hatch",
                             "add fill=COLOUR, or use beam=outline");
    for (const std::string_view property : {"hatch", "hatch-angle"})
        if (has_property(node, property) && !style.has_hatching())
            context.report.warning(property_span(node, property),
                                   std::string{property} + " does nothing without a hatching",
                                   "add beam=hatch or remove " + std::string{property});
}

constexpr std::array changes{Word<bool>{"canvas", false}, Word<bool>{"bones", true}};

bool read_change(const kdl::Value& value, Target& target, SceneContext& context)
{
    return assign(read_word(value, changes, context.report), target.turns_changes);
}

constexpr std::array skin_rules{
    PropertyRule<Target>{"skin", keep_name<&Target::skin>, any_name},
    PropertyRule<Target>{"bone", keep_name<&Target::bone>, any_name},
    PropertyRule<Target>{"bones", keep_name<&Target::bones>, any_text},
    PropertyRule<Target>{"change", read_change, ValueKind::one_of<changes>(), false, "skin"},
};

constexpr auto object_rules =
    joined(style_rules, beam_rules, skin_rules, trim_rules<Target>,
           std::array{PropertyRule<Target>{"trim", read_own_value<Property::trim_mode>,
                                           kind_of(Property::trim_mode)}},
           dash_rules<Target>, place_rules<Target>, show_rules<Target>, pivot_rules<Target>,
           std::array{PropertyRule<Target>{"input", read_own_driver<Target>, any_name},
                      PropertyRule<Target>{"live", keep_name<&Target::live>, any_name}});

}

std::optional<std::size_t> ObjectProperties::fill_colour() const
{
    const auto colour = values.get(Property::fill);
    return colour ? std::optional{static_cast<std::size_t>(*colour)} : std::nullopt;
}

std::optional<StrokeStyle> ObjectProperties::stroke_style() const
{
    const auto colour = values.get(Property::stroke);
    if (!colour)
        return std::nullopt;
    StrokeStyle style = stroke;
    style.colour = static_cast<std::size_t>(*colour);
    style.width = values.get(Property::width).value_or(style.width);
    return style;
}

ObjectProperties read_object_properties(const kdl::Node& node, SourceSpan place, SceneContext& context)
{
    ObjectProperties properties;
    read_properties(node, object_rules, properties, context);
    if (!has_property(node, "fill") && !has_property(node, "stroke"))
        context.report.error(place, "this object would not be seen: it has neither fill nor stroke",
                             "add fill=COLOUR or stroke=COLOUR");
    check_beam(node, properties.beam, context);
    return properties;
}

std::vector<PropertySchema> object_property_schema() { return schema_of(object_rules); }

}
