#include "host/words/easing_names.hpp"

#include "host/words/law_words.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace kfast {

namespace {

// The beziers of quart to circ, and of all forms at both ends, were found by a search for the smallest
// largest distance; tests/host/scene/easing_names_test.cpp has the distances.
constexpr std::array easing_table{
    EasingName{"linear", "constant"},
    EasingName{"cubic-bezier", "bezier"},
    EasingName{"step-end", "hold"},
    EasingName{"ease-in-sine", "accelerate"},
    EasingName{"ease-out-sine", "decelerate"},
    EasingName{"ease-in-out-sine", "accelerate-decelerate"},
    EasingName{"ease-in-quad", "bezier(0.33333,0,0.66667,0.33333)"},
    EasingName{"ease-out-quad", "bezier(0.33333,0.66667,0.66667,1)"},
    EasingName{"ease-in-out-quad", "bezier(0.484,0.042,0.516,0.958)"},
    EasingName{"ease-in-cubic", "bezier(0.33333,0,0.66667,0)"},
    EasingName{"ease-out-cubic", "bezier(0.33333,1,0.66667,1)"},
    EasingName{"ease-in-out-cubic", "bezier(0.625,-0.041,0.375,1.041)"},
    EasingName{"ease-in-quart", "bezier(0.475,-0.004,0.741,-0.024)"},
    EasingName{"ease-out-quart", "bezier(0.259,1.024,0.525,1.004)"},
    EasingName{"ease-in-out-quart", "bezier(0.715,-0.089,0.285,1.089)"},
    EasingName{"ease-in-quint", "bezier(0.603,-0.015,0.79,-0.01)"},
    EasingName{"ease-out-quint", "bezier(0.21,1.01,0.397,1.015)"},
    EasingName{"ease-in-out-quint", "bezier(0.774,-0.123,0.226,1.123)"},
    EasingName{"ease-in-expo", "bezier(0.632,0.02,0.845,-0.064)"},
    EasingName{"ease-out-expo", "bezier(0.155,1.064,0.368,0.98)"},
    EasingName{"ease-in-out-expo", "bezier(0.842,-0.119,0.158,1.119)"},
    EasingName{"ease-in-circ", "bezier(0.579,0.004,1,0.47)"},
    EasingName{"ease-out-circ", "bezier(0,0.53,0.421,0.996)"},
    EasingName{"ease-in-out-circ", "bezier(0.94,0.211,0.06,0.789)"},
    EasingName{"ease-in-back", "back-in"},
    EasingName{"ease-out-back", "back"},
    EasingName{"ease-in-out-back", "back-in-out"},
    EasingName{"ease-in-elastic", "elastic-in"},
    EasingName{"ease-out-elastic", "elastic"},
    EasingName{"ease-in-out-elastic", "elastic-in-out"},
    EasingName{"ease-in-bounce", "bounce-in"},
    EasingName{"ease-out-bounce", "bounce"},
    EasingName{"ease-in-out-bounce", "bounce-in-out"},
};

}

std::span<const EasingName> easing_names() { return easing_table; }

std::string_view law_of_easing(std::string_view word)
{
    const std::string plain = plain_word(word);
    if (const auto own = std::ranges::find(law_words, plain, &LawWord::keyword); own != law_words.end())
        return own->keyword;
    const auto easing = std::ranges::find(easing_table, plain, &EasingName::name);
    return easing == easing_table.end() ? std::string_view{} : easing->law;
}

}
