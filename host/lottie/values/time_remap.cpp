#include "host/lottie/values/time_remap.hpp"

#include "host/art/animation/ease.hpp"
#include "host/art/document/document.hpp"
#include "host/art/document/value_distance.hpp"
#include "host/lottie/values/ways.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::lottie {
namespace {

using art::EaseKind;
using art::mixed;
using art::same_form;

/// Where time runs slower than that, it is taken as stopped.
constexpr double slowest = 1e-6;

TimePiece piece_between(double from, double to, double begin, double end)
{
    return {from, to, begin, std::abs(end - begin) < slowest ? begin : end};
}

void add_eased(std::vector<TimePiece>& pieces, const art::Channel& frame, double from, double to,
               art::Budget& budget)
{
    while (from < to) {
        budget.take_keys(1);
        const double next = std::min(to, std::floor(from) + 1);
        pieces.push_back(piece_between(from, next, frame.at(from), frame.at(next)));
        from = next;
    }
}

/// Adds the part of a transition between two of its times.
template <typename Value>
void add_stretch(std::vector<Way<Value>>& ways, const art::Key<Value>& key, const art::Key<Value>& next,
                 double from, double to)
{
    if (key.ease.kind == EaseKind::hold) {
        ways.push_back({from, to, key.value, key.value, key.ease});
        return;
    }
    const double span = next.time - key.time;
    for (const art::EasePart& part :
         art::ease_parts(key.ease, (from - key.time) / span, (to - key.time) / span))
        ways.push_back({key.time + part.from * span, key.time + part.to * span,
                        mixed(key.value, next.value, part.way_from),
                        mixed(key.value, next.value, part.way_to), part.ease});
}

/// The transitions between two frames of the composition, in its own times.
template <typename Value>
std::vector<Way<Value>> ways_within(const art::Animated<Value>& animated, double from, double to)
{
    const auto& keys = animated.keys;
    std::vector<Way<Value>> ways;
    if (from < keys.front().time)
        ways.push_back({from, std::min(to, keys.front().time), keys.front().value, keys.front().value, {}});
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const double begin = std::max(from, keys[i].time);
        const double end = std::min(to, keys[i + 1].time);
        if (begin < end)
            add_stretch(ways, keys[i], keys[i + 1], begin, end);
    }
    if (to > keys.back().time)
        ways.push_back({std::max(from, keys.back().time), to, keys.back().value, keys.back().value, {}});
    return ways;
}

template <typename Value>
void add_ways(std::vector<Way<Value>>& ways, const art::Animated<Value>& animated, const TimePiece& piece)
{
    if (piece.begin == piece.end) {
        const Value value = animated.at(piece.begin);
        ways.push_back({piece.from, piece.to, value, value, {}});
        return;
    }
    auto stretched =
        ways_within(animated, std::min(piece.begin, piece.end), std::max(piece.begin, piece.end));
    const double slope = (piece.to - piece.from) / (piece.end - piece.begin);
    place_in_scene(stretched, {.start = piece.from - slope * piece.begin, .stretch = slope});
    ways.insert(ways.end(), stretched.begin(), stretched.end());
}

/// A difference by rounding alone is no jump.
template <typename Value>
void mend(std::vector<Way<Value>>& ways)
{
    constexpr double rounding = 1e-9;
    for (std::size_t i = 1; i < ways.size(); ++i) {
        const Value& before = ways[i - 1].end;
        if (!same_form(before, ways[i].begin) || art::distance(before, ways[i].begin) > rounding)
            continue;
        if (ways[i].begin == ways[i].end)
            ways[i].end = before;
        ways[i].begin = before;
    }
}

void take(art::Budget&, const art::Channel&) {}
void take(art::Budget&, const art::Animated<art::Rgb>&) {}
void take(art::Budget& budget, const art::Animated<art::Drawing>& drawings)
{
    for (const auto& key : drawings.keys)
        for (const scene::Outline& outline : key.value.outlines)
            budget.take_points(outline.curves.size() + 1);
}

template <typename Value>
void retime(art::Animated<Value>& animated, const std::vector<TimePiece>& pieces, art::Budget& budget)
{
    if (animated.is_still())
        return;
    constexpr double endless = std::numeric_limits<double>::infinity();
    const Value first = animated.at(pieces.front().begin);
    std::vector<Way<Value>> ways{{-endless, pieces.front().from, first, first, {}}};
    for (const TimePiece& piece : pieces) {
        budget.take_keys(1);
        budget.take_computed_points(animated.keys.size());
        add_ways(ways, animated, piece);
    }
    ways.push_back({pieces.back().to, endless, ways.back().end, ways.back().end, {}});
    mend(ways);
    animated = joined(ways);
    budget.take_keys(animated.keys.size());
    take(budget, animated);
}

/// When spans of the composition are visible, ascending and disjoint.
std::vector<art::Span> retimed(const std::vector<art::Span>& spans, const std::vector<TimePiece>& pieces)
{
    std::vector<art::Span> result;
    const auto add = [&](double from, double to) {
        if (!result.empty() && from <= result.back().to + 1e-9)
            result.back().to = std::max(result.back().to, to);
        else if (from < to)
            result.push_back({from, to});
    };
    for (const TimePiece& piece : pieces) {
        std::vector<art::Span> here;
        const double slope =
            piece.begin == piece.end ? 0 : (piece.to - piece.from) / (piece.end - piece.begin);
        for (const art::Span& span : spans) {
            const double from = std::max(span.from, std::min(piece.begin, piece.end));
            const double to = std::min(span.to, std::max(piece.begin, piece.end));
            const double a = piece.from + slope * (from - piece.begin);
            const double b = piece.from + slope * (to - piece.begin);
            if (slope == 0 && span.from <= piece.begin && piece.begin < span.to)
                here.push_back({piece.from, piece.to});
            else if (slope != 0 && from < to)
                here.push_back({std::min(a, b), std::max(a, b)});
        }
        std::ranges::sort(here, {}, &art::Span::from);
        for (const art::Span& span : here)
            add(span.from, span.to);
    }
    return result;
}

bool is_always(const std::vector<art::Span>& spans) { return spans == std::vector<art::Span>{{}}; }

}

std::vector<TimePiece> time_pieces(const art::Channel& frame, const art::Span& span, art::Budget& budget)
{
    std::vector<TimePiece> pieces;
    const auto& keys = frame.keys;
    const auto add_still = [&](double from, double to, double value) {
        if (from < to)
            pieces.push_back({from, to, value, value});
    };
    add_still(span.from, std::min(span.to, keys.front().time), keys.front().value);
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const double from = std::max(span.from, keys[i].time);
        const double to = std::min(span.to, keys[i + 1].time);
        if (!(from < to))
            continue;
        if (keys[i].ease.kind == EaseKind::hold || keys[i].value == keys[i + 1].value) {
            add_still(from, to, keys[i].value);
        } else if (keys[i].ease.kind == EaseKind::cubic) {
            add_eased(pieces, frame, from, to, budget);
        } else {
            const auto value = [&](double time) {
                return art::mixed(keys[i].value, keys[i + 1].value,
                                  (time - keys[i].time) / (keys[i + 1].time - keys[i].time));
            };
            pieces.push_back(piece_between(from, to, value(from), value(to)));
        }
    }
    add_still(std::max(span.from, keys.back().time), span.to, keys.back().value);
    return pieces;
}

void retime(std::vector<art::Node>& nodes, const std::vector<TimePiece>& pieces, art::Budget& budget)
{
    const auto change = [&](auto& animated) { retime(animated, pieces, budget); };
    art::every_node(nodes, [&](art::Node& node, const std::string&) {
        if (!is_always(node.shown))
            node.shown = retimed(node.shown, pieces);
        change(node.opacity);
        art::every_animation(node.transform, change);
        if (auto* shape = std::get_if<art::Shape>(&node.content))
            art::every_animation(*shape, change);
    });
}

}
