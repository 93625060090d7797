#include "tests/fuzz/kinds.hpp"

#include <cstdio>
#include <string_view>
#include <vector>

namespace kfast::test {
namespace {

/// Each kind that there is, and the names of its variants, by their numbers in the format.
struct Kind {
    std::string_view section;
    std::string_view name;
    std::vector<std::string_view> variants = {"no", "yes"};
};

const std::vector<Kind> kinds{
    {"Header", "end", {"stop", "repeat", "ping-pong"}},
    {"Header", "camera"},
    {"Header", "rate", {"per second", "per 1000 seconds"}},
    {"Palette", "opacity"},
    {"Laws",
     "law",
     {"constant", "accelerate", "decelerate", "accelerate-decelerate", "hold", "steps", "bezier", "bounce",
      "spring"}},
    {"Laws", "springs at", {"the next key", "the earlier key", "both"}},
    {"Laws", "law for y", {"as for x", "its own"}},
    {"Inputs", "kind", {"number", "text", "drawing"}},
    {"Numbers", "usual value", {"least", "between", "greatest"}},
    {"Texts", "stretches", {"one", "several"}},
    {"Texts", "usual text", {"empty", "some"}},
    {"Drawings from outside", "usual drawing", {"empty", "some"}},
    {"Clocks", "reads", {"time", "clock"}},
    {"Clocks", "at its end", {"stop", "repeat", "ping-pong"}},
    {"Clocks", "length", {"none", "some"}},
    {"Clocks", "speed", {"forwards", "backwards"}},
    {"Marks", "clip", {"stop", "repeat", "ping-pong"}},
    {"Marks", "event", {"any"}},
    {"Key times", "go by", {"time", "input", "clock"}},
    {"Key times", "number", {"one", "several"}},
    {"Bones", "parent", {"root", "child"}},
    {"Bones", "keys of", {"angle", "x", "y", "length"}},
    {"Bones", "moves with tip"},
    {"Bones", "turns as written"},
    {"Bones", "common key times"},
    {"Symbols", "symbol", {"any"}},
    {"Items", "kind", {"object", "group", "use", "live"}},
    {"Items", "filled"},
    {"Items", "stroked"},
    {"Items", "rule", {"nonzero", "even-odd"}},
    {"Items", "arrival drawings"},
    {"Items", "carried by", {"nothing", "backbones", "bones"}},
    {"Items", "cap", {"butt", "round", "square"}},
    {"Items", "join", {"miter", "round", "bevel"}},
    {"Live items", "shows", {"drawing", "label"}},
    {"Live items", "place", {"right", "middle", "left"}},
    {"Live items", "kerned"},
    {"Live items", "number"},
    {"Live items", "decimals"},
    {"Live items", "gaps"},
    {"Live items", "around a number"},
    {"Live items", "spacing"},
    {"Wire frames", "depths"},
    {"Skins", "is", {"bindings", "one bone"}},
    {"Skins", "drawing at rest"},
    {"Skins", "fine weights"},
    {"Backbones", "number", {"one", "several"}},
    {"Tracks",
     "fixed",
     {"x", "y", "z", "rotation-x", "rotation-y", "rotation", "scale-x", "scale-y", "pivot-x", "pivot-y",
      "along", "opacity", "order", "visible"}},
    {"Tracks",
     "fixed cut",
     {"trim-from", "trim-to", "trim-offset", "trim", "dash-offset", "dash-1", "gap-1", "dash-2", "gap-2",
      "dash-3", "gap-3", "max-dashes"}},
    {"Tracks",
     "keys of",
     {"x", "y", "z", "rotation-x", "rotation-y", "rotation", "scale-x", "scale-y", "pivot-x", "pivot-y",
      "along", "opacity", "order", "visible", "fill", "stroke", "width"}},
    {"Tracks",
     "keys of cut",
     {"trim-from", "trim-to", "trim-offset", "dash-offset", "dash-1", "gap-1", "dash-2", "gap-2", "dash-3",
      "gap-3"}},
    {"Tracks", "smooth"},
    {"Tracks", "beam style", {"nothing", "outline", "hatching", "both"}},
    {"Tracks", "path turns"},
    {"Drawings", "strokes", {"none", "one", "several"}},
    {"Drawings", "mirrored", {"no", "x", "y", "both"}},
    {"Forms", "segments", {"lines", "cubics", "both", "elsewhere"}},
    {"Forms", "end", {"as it comes", "closes", "turned"}},
    {"Forms", "sparse ends"},
    {"Forms", "sparse control points"},
    {"Forms", "smoothness", {"0", "1", "2", "3"}},
    {"Forms", "predicted"},
};

}

std::size_t Census::count(const std::string& kind, std::size_t variant) const
{
    const auto found = seen_.find(kind);
    return found != seen_.end() && found->second.contains(variant) ? found->second.at(variant) : 0;
}

bool Census::print() const
{
    bool has_all = true;
    for (const Kind& kind : kinds)
        for (std::size_t variant = 0; variant < kind.variants.size(); ++variant) {
            const std::string name = std::string{kind.section} + ": " + std::string{kind.name};
            const std::string line = name + " " + std::string{kind.variants[variant]};
            if (const std::size_t times = count(name, variant))
                std::printf("%s %zu\n", line.c_str(), times);
            else
                std::fprintf(stderr, "Nothing has %s\n", line.c_str());
            has_all = has_all && count(name, variant) != 0;
        }
    return has_all;
}

}
