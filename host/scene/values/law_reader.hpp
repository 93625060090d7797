#pragma once

#include "core/time/velocity_law.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/report.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// A velocity law: a word, or a text such as "steps(4)" or "bezier(0.42, 0, 0.58, 1)", whose numbers are
/// rounded once to 1/8192. What is wrong is reported at its position inside the text.
std::optional<VelocityLaw> read_law(const kdl::Value& value, schema::Report& report);

/// All laws as they are written: "hold", "steps(n)"
std::vector<std::string_view> law_forms();

/// The laws that a key names. That of one axis wins over `law`, whichever is written first.
struct KeyLaws {
    std::optional<VelocityLaw> both;
    std::optional<VelocityLaw> x;
    std::optional<VelocityLaw> y;

    /// For what has an x or a y: position, scale, drawing.
    LawPair of_axes() const { return {x.value_or(of_rest().x), y.value_or(of_rest().y)}; }
    /// For what has no axis.
    LawPair of_rest() const
    {
        const VelocityLaw law = both.value_or(VelocityLaw{});
        return {law, law};
    }
};

template <std::optional<VelocityLaw> KeyLaws::*law, class Target>
bool read_key_law(const kdl::Value& value, Target& target, SceneContext& context)
{
    return assign(read_law(value, context.report), target.laws.*law);
}

/// A Target has a member KeyLaws `laws`.
template <class Target>
inline constexpr std::array law_rules{
    PropertyRule<Target>{"law", read_key_law<&KeyLaws::both>, any_law},
    PropertyRule<Target>{"law-x", read_key_law<&KeyLaws::x>, any_law},
    PropertyRule<Target>{"law-y", read_key_law<&KeyLaws::y>, any_law},
};

}
