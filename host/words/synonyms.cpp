#include "host/words/synonyms.hpp"

#include "host/text/suggestion.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace kfast {
namespace {

constexpr std::array synonym_table{
    // properties of items
    Synonym{"rotation", "rotate"},
    Synonym{"rotation", "turn"},
    Synonym{"angle", "rotate"},
    Synonym{"angle", "turn"},
    Synonym{"rotation-x", "rotate-x"},
    Synonym{"rotation-y", "rotate-y"},
    Synonym{"rotation-z", "rotate-z"},
    Synonym{"alpha", "opacity"},
    Synonym{"z-index", "order"},
    Synonym{"layer", "order"},
    Synonym{"depth", "z"},
    Synonym{"visibility", "visible"},
    Synonym{"display", "visible"},
    Synonym{"translate-x", "x"},
    Synonym{"translate-y", "y"},
    Synonym{"translate-z", "z"},
    Synonym{"zoom", "scale"},
    Synonym{"origin-x", "pivot-x"},
    Synonym{"anchor-x", "pivot-x"},
    Synonym{"origin-y", "pivot-y"},
    Synonym{"anchor-y", "pivot-y"},
    Synonym{"origin", "pivot-x"},
    Synonym{"transform-origin", "pivot-x"},
    Synonym{"pivot", "pivot-x"},
    // properties of objects
    Synonym{"color", "fill"},
    Synonym{"colour", "fill"},
    Synonym{"fill-color", "fill"},
    Synonym{"fill-colour", "fill"},
    Synonym{"stroke-color", "stroke"},
    Synonym{"stroke-colour", "stroke"},
    Synonym{"line-color", "stroke"},
    Synonym{"line-colour", "stroke"},
    Synonym{"outline", "stroke"},
    Synonym{"border", "stroke"},
    Synonym{"stroke-width", "width"},
    Synonym{"line-width", "width"},
    Synonym{"border-width", "width"},
    Synonym{"thickness", "width"},
    Synonym{"stroke-dasharray", "dash"},
    Synonym{"dasharray", "dash"},
    Synonym{"dash-array", "dash"},
    Synonym{"dashes", "dash"},
    Synonym{"stroke-dashoffset", "dash-offset"},
    Synonym{"dashoffset", "dash-offset"},
    Synonym{"stroke-linecap", "cap"},
    Synonym{"line-cap", "cap"},
    Synonym{"linecap", "cap"},
    Synonym{"stroke-linejoin", "join"},
    Synonym{"line-join", "join"},
    Synonym{"linejoin", "join"},
    Synonym{"stroke-miterlimit", "miter"},
    Synonym{"miter-limit", "miter"},
    Synonym{"miterlimit", "miter"},
    Synonym{"fill-rule", "rule"},
    Synonym{"skeleton", "skin"},
    // of shapes
    Synonym{"radius", "r"},
    Synonym{"radius", "corner"},
    Synonym{"rx", "corner"},
    Synonym{"ry", "corner"},
    Synonym{"rx", "r"},
    Synonym{"ry", "r"},
    Synonym{"radius-x", "rx"},
    Synonym{"radius-y", "ry"},
    Synonym{"corner-radius", "corner"},
    Synonym{"border-radius", "corner"},
    Synonym{"rounded", "corner"},
    Synonym{"start", "from"},
    Synonym{"start-angle", "from"},
    Synonym{"begin", "from"},
    Synonym{"end", "to"},
    Synonym{"end-angle", "to"},
    Synonym{"stop", "to"},
    Synonym{"inner-radius", "inner"},
    Synonym{"outer-radius", "r"},
    Synonym{"points", "sides"},
    Synonym{"corners", "sides"},
    Synonym{"sides", "points"},
    Synonym{"tips", "points"},
    Synonym{"rotate", "turn"},
    // of texts
    Synonym{"font-size", "size"},
    Synonym{"font-family", "font"},
    Synonym{"face", "font"},
    Synonym{"text-anchor", "align"},
    Synonym{"valign", "vertical"},
    Synonym{"vertical-align", "vertical"},
    Synonym{"dominant-baseline", "vertical"},
    Synonym{"text-align", "align"},
    Synonym{"anchor", "align"},
    Synonym{"anchor", "pivot-x"},
    Synonym{"letter-spacing", "spacing"},
    Synonym{"tracking", "spacing"},
    Synonym{"line-height", "leading"},
    Synonym{"line-spacing", "leading"},
    Synonym{"position", "at"},
    // of symbols and their uses
    Synonym{"repeat", "use"},
    Synonym{"repeater", "use"},
    Synonym{"copies", "count"},
    Synonym{"repeat", "count"},
    Synonym{"begin", "delay"},
    Synonym{"start", "delay"},
    Synonym{"animation-delay", "delay"},
    Synonym{"stagger", "delay-step"},
    Synonym{"playback-rate", "speed"},
    Synonym{"iteration-count", "loop"},
    Synonym{"color-step", "colour-step"},
    // of keys, the canvas and inputs
    Synonym{"ease", "law"},
    Synonym{"easing", "law"},
    Synonym{"timing", "law"},
    Synonym{"timing-function", "law"},
    Synonym{"interpolation", "law"},
    Synonym{"duration", "frames"},
    Synonym{"length", "frames"},
    Synonym{"rate", "fps"},
    Synonym{"framerate", "fps"},
    Synonym{"frame-rate", "fps"},
    Synonym{"repeat", "loop"},
    Synonym{"bg", "background"},
    Synonym{"fill", "background"},
    Synonym{"color", "background"},
    Synonym{"colour", "background"},
    Synonym{"background-color", "background"},
    Synonym{"background-colour", "background"},
    Synonym{"value", "default"},
    Synonym{"initial", "default"},
    Synonym{"minimum", "min"},
    Synonym{"maximum", "max"},
    Synonym{"type", "kind"},
    Synonym{"characters", "glyphs"},
    Synonym{"flip", "mirror"},
    // nodes
    Synonym{"triangle", "polygon"},
    Synonym{"polyline", "line"},
    Synonym{"lines", "line"},
    Synonym{"rectangle", "rect"},
    Synonym{"square", "rect"},
    Synonym{"box", "rect"},
    Synonym{"cube", "cuboid"},
    Synonym{"oval", "ellipse"},
    Synonym{"disc", "circle"},
    Synonym{"disk", "circle"},
    Synonym{"dot", "circle"},
    Synonym{"sector", "pie"},
    Synonym{"wedge", "pie"},
    Synonym{"ring", "pie"},
    Synonym{"donut", "pie"},
    Synonym{"hexagon", "regular"},
    Synonym{"pentagon", "regular"},
    Synonym{"spline", "curve"},
    Synonym{"bezier", "path"},
    Synonym{"label", "text"},
    Synonym{"tspan", "text"},
    Synonym{"sprite", "object"},
    Synonym{"shape", "object"},
    Synonym{"layer", "group"},
    Synonym{"g", "group"},
    Synonym{"folder", "group"},
    Synonym{"component", "symbol"},
    Synonym{"template", "symbol"},
    Synonym{"instance", "use"},
    Synonym{"clone", "use"},
    Synonym{"keyframe", "key"},
    Synonym{"frame", "key"},
    Synonym{"at", "key"},
    Synonym{"key", "at"},
    Synonym{"keyframe", "at"},
    Synonym{"animate", "track"},
    Synonym{"animation", "track"},
    Synonym{"tween", "track"},
    Synonym{"armature", "bones"},
    Synonym{"rig", "bones"},
    Synonym{"skeleton", "bones"},
    Synonym{"joint", "bone"},
    Synonym{"ik", "reach"},
    Synonym{"stage", "canvas"},
    Synonym{"screen", "canvas"},
    Synonym{"size", "canvas"},
    Synonym{"colors", "palette"},
    Synonym{"colours", "palette"},
    Synonym{"variable", "let"},
    Synonym{"var", "let"},
    Synonym{"const", "let"},
    Synonym{"define", "let"},
    Synonym{"parameter", "input"},
    Synonym{"slider", "input"},
    Synonym{"marker", "event"},
    Synonym{"segment", "clip"},
    Synonym{"version", "kfast"},
    // laws and other values
    Synonym{"step", "hold"},
    Synonym{"discrete", "hold"},
    Synonym{"middle", "center"},
    Synonym{"centre", "center"},
    Synonym{"start", "left"},
    Synonym{"end", "right"},
    Synonym{"evenodd", "even-odd"},
    Synonym{"non-zero", "nonzero"},
    Synonym{"flat", "butt"},
    Synonym{"mitre", "miter"},
    Synonym{"forever", "repeat"},
    Synonym{"infinite", "repeat"},
    Synonym{"loop", "repeat"},
    Synonym{"alternate", "ping-pong"},
    Synonym{"bounce", "ping-pong"},
    Synonym{"yoyo", "ping-pong"},
    Synonym{"horizontal", "x"},
    Synonym{"vertical", "y"},
    Synonym{"float", "number"},
    Synonym{"int", "number"},
    Synonym{"string", "text"},
};

/// What other programs have and the language does not, by their names for it.
struct Absent {
    std::string_view word;
    std::string_view things;
};

constexpr std::array absents{
    Absent{"gradient", "gradients"},
    Absent{"linear-gradient", "gradients"},
    Absent{"radial-gradient", "gradients"},
    Absent{"conic-gradient", "gradients"},
    Absent{"image", "images"},
    Absent{"img", "images"},
    Absent{"bitmap", "images"},
    Absent{"picture", "images"},
    Absent{"texture", "images"},
    Absent{"mask", "masks"},
    Absent{"clip-path", "masks"},
    Absent{"matte", "masks"},
    Absent{"step-start", "jumps at the beginning"},
    Absent{"state", "states"},
    Absent{"states", "states"},
    Absent{"state-machine", "states"},
    Absent{"transition", "states"},
    Absent{"blur", "effects"},
    Absent{"shadow", "effects"},
    Absent{"drop-shadow", "effects"},
    Absent{"filter", "effects"},
    Absent{"blend-mode", "effects"},
    Absent{"sound", "sounds"},
    Absent{"audio", "sounds"},
};

bool is_among(std::span<const std::string_view> known, std::string_view word)
{
    return std::ranges::find(known, word) != known.end();
}

}

std::span<const Synonym> synonyms() { return synonym_table; }

std::string plain_word(std::string_view word)
{
    std::string text;
    for (const char letter : word) {
        const auto code = static_cast<unsigned char>(letter);
        if (std::isupper(code) != 0 && !text.empty() && text.back() != '-')
            text += '-';
        text += letter == '_' ? '-' : static_cast<char>(std::tolower(code));
    }
    return text;
}

std::string hint_of_absent(std::string_view word)
{
    const auto absent = std::ranges::find(absents, plain_word(word), &Absent::word);
    if (absent == absents.end())
        return {};
    return "there are no " + std::string{absent->things} +
           ": docs/scene-language.md#not-there has what to write instead";
}

std::string_view meaning_among(std::span<const std::string_view> known, std::string_view word)
{
    const std::string name = plain_word(word);
    if (const auto same = std::ranges::find(known, name); same != known.end())
        return *same;
    const auto synonym = std::ranges::find_if(synonym_table, [&](const Synonym& candidate) {
        return candidate.word == name && is_among(known, candidate.meaning);
    });
    return synonym == synonym_table.end() ? std::string_view{} : synonym->meaning;
}

std::string word_hint(std::string_view word, std::span<const std::string_view> known)
{
    if (const std::string_view meaning = meaning_among(known, word); !meaning.empty())
        return "KFAST calls it \"" + std::string{meaning} + '"';
    const std::string absent = hint_of_absent(word);
    return absent.empty() ? suggestion(word, known) : absent;
}

}
