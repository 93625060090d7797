#pragma once

#include "core/time/velocity_law.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace kfast {

/// A law with the curve that CSS calls cubic-bezier(x1, y1, x2, y2), each number rounded once to 1/8192,
/// halves away from zero. x1 and x2 are 0 … 1, y1 and y2 are −2 … 3.
constexpr VelocityLaw bezier_law(double x1, double y1, double x2, double y2)
{
    const auto control = [](double number) {
        return static_cast<std::int16_t>(number * VelocityLaw::control_one + (number < 0 ? -0.5 : 0.5));
    };
    return VelocityLaw::bezier(control(x1), control(y1), control(x2), control(y2));
}

/// What the scene language calls a velocity law.
struct LawWord {
    std::string_view keyword; ///< "hold", "steps"
    std::string_view form;    ///< as it is written, with the names of its numbers: "hold", "steps(n)"
    VelocityLaw law;          ///< of a law with numbers its kind alone

    constexpr bool has_numbers() const { return form != keyword; }
};

/// All laws. The names that begin with ease have the curves that they have in CSS. The number of back is the
/// s of Robert Penner's easing functions, whose back-in-out the bezier is nearest to: 0.023 away at most.
inline constexpr std::array law_words{
    LawWord{"constant", "constant", VelocityLaw::constant},
    LawWord{"accelerate", "accelerate", VelocityLaw::accelerate},
    LawWord{"decelerate", "decelerate", VelocityLaw::decelerate},
    LawWord{"accelerate-decelerate", "accelerate-decelerate", VelocityLaw::accelerate_decelerate},
    LawWord{"hold", "hold", VelocityLaw::hold},
    LawWord{"ease", "ease", bezier_law(0.25, 0.1, 0.25, 1)},
    LawWord{"ease-in", "ease-in", bezier_law(0.42, 0, 1, 1)},
    LawWord{"ease-out", "ease-out", bezier_law(0, 0, 0.58, 1)},
    LawWord{"ease-in-out", "ease-in-out", bezier_law(0.42, 0, 0.58, 1)},
    LawWord{"steps", "steps(n)", {.kind = VelocityLaw::Kind::steps}},
    LawWord{"bezier", "bezier(x1,y1,x2,y2)", {.kind = VelocityLaw::Kind::bezier}},
    LawWord{"back", "back(s)", {.kind = VelocityLaw::Kind::bezier}},
    LawWord{"back-in", "back-in(s)", {.kind = VelocityLaw::Kind::bezier}},
    LawWord{"back-in-out", "back-in-out", bezier_law(0.744, -0.513, 0.256, 1.513)},
    LawWord{"spring", "spring(stiffness,damping)", {.kind = VelocityLaw::Kind::spring}},
    LawWord{"elastic", "elastic(period)", {.kind = VelocityLaw::Kind::spring}},
    LawWord{"elastic-in", "elastic-in(period)", {.kind = VelocityLaw::Kind::spring}},
    LawWord{"elastic-in-out", "elastic-in-out(period)", {.kind = VelocityLaw::Kind::spring}},
    LawWord{"bounce", "bounce(n)", {.kind = VelocityLaw::Kind::bounce}},
    LawWord{"bounce-in", "bounce-in(n)", {.kind = VelocityLaw::Kind::bounce}},
    LawWord{"bounce-in-out", "bounce-in-out(n)", {.kind = VelocityLaw::Kind::bounce}},
};

/// The keyword of a law that is written without numbers: "hold", "ease-in"; empty if it has none.
constexpr std::string_view keyword_of(const VelocityLaw& law)
{
    const auto word = std::ranges::find(law_words, law, &LawWord::law);
    return word != law_words.end() && !word->has_numbers() ? word->keyword : std::string_view{};
}

/// `keyword` is that of a row.
constexpr const LawWord& word_called(std::string_view keyword)
{
    return *std::ranges::find(law_words, keyword, &LawWord::keyword);
}

/// The first row of a kind: of VelocityLaw::Kind::bezier that with the control points.
constexpr const LawWord& word_of(VelocityLaw::Kind kind)
{
    return *std::ranges::find(law_words, VelocityLaw{.kind = kind}, &LawWord::law);
}

}
