#include "host/lottie/layers/layer.hpp"

#include "host/geometry/shape.hpp"
#include "host/lottie/drawings/extent.hpp"
#include "host/lottie/layers/composition_symbol.hpp"
#include "host/lottie/layers/window.hpp"
#include "host/lottie/values/time_remap.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::lottie {
namespace {

// Times of the scene are at most this many times those of the file, so that moments of the file stay
// distinct.
constexpr double largest_stretch = 1000;

/// The composition that a layer shows, among those that are open while it is read.
class Opened {
public:
    Opened(const Layer& layer, Animation& animation) : animation_{animation}
    {
        const std::string id = identifier_at(layer.json, "refId");
        const auto asset = animation.assets.find(id);
        if (asset == animation.assets.end())
            throw WrongMember(layer.json, "its composition " + in_quotes(id) +
                                              " is not among the assets: export the "
                                              "file again");
        if (std::ranges::find(animation.open, id) != animation.open.end())
            throw WrongMember(layer.json,
                              "the composition " + in_quotes(id) + " uses itself: take this layer out");
        layers_ = &array_at(*asset->second, "layers");
        if (number_at(*asset->second, "fr", animation.frame_rate) != animation.frame_rate)
            layer.reading.losses.add({"frame rate of a composition", layer.reading.layer, std::nullopt,
                                      "that of the whole animation"});
        animation_.open.push_back(id);
    }
    ~Opened() { animation_.open.pop_back(); }
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;

    const Json& layers() const { return *layers_; }

private:
    Animation& animation_;
    const Json* layers_ = nullptr;
};

/// The time inside of the layer: 1 frame there takes "sr" frames outside.
LayerTime stretched(const Layer& layer)
{
    const LayerTime& outer = layer.reading.time;
    const double stretch = number_at(layer.json, "sr", 1);
    const double start = number_at(layer.json, "st", 0);
    if (stretch == 0)
        throw WrongMember(layer.json, "\"sr\" is 0: 1 is the usual stretch");
    const LayerTime time{.start = outer.scene_frame(start), .stretch = outer.stretch * stretch};
    if (!(std::abs(time.stretch) >= 1 / largest_stretch && std::abs(time.stretch) <= largest_stretch))
        throw WrongMember(layer.json, "\"sr\" is too far from 1, with those of the layers around it");
    return time;
}

/// A remapping that is linear throughout is a stretch.
std::optional<LayerTime> even_time(const std::vector<TimePiece>& pieces)
{
    if (pieces.size() != 1 || pieces.front().begin == pieces.front().end)
        return std::nullopt;
    const TimePiece& piece = pieces.front();
    const double stretch = (piece.to - piece.from) / (piece.end - piece.begin);
    if (std::abs(stretch) > largest_stretch)
        return std::nullopt;
    return LayerTime{.start = piece.from - stretch * piece.begin, .stretch = stretch};
}

/// All frames of the composition that are shown; never empty.
art::Span range_of(const std::vector<TimePiece>& pieces)
{
    art::Span range{pieces.front().begin, pieces.front().begin};
    for (const TimePiece& piece : pieces) {
        range.from = std::min({range.from, piece.begin, piece.end});
        range.to = std::max({range.to, piece.begin, piece.end});
    }
    range.to += 1;
    return range;
}

Reading inner_reading(const Layer& layer, const LayerTime& time)
{
    Reading reading = layer.reading;
    reading.time = time;
    ++reading.depth;
    art::Budget::check_depth(reading.depth);
    return reading;
}

/// A layer that stops at its end shows the frame before: the end itself is not inside.
void keep_last_frame(std::vector<TimePiece>& pieces, double end)
{
    for (TimePiece& piece : pieces)
        if (piece.begin == end && piece.end == end)
            piece.begin = piece.end = end - 1;
}

/// "tm" counts seconds.
std::vector<TimePiece> read_pieces(const Layer& layer, const Animation& animation)
{
    const Reading& outer = layer.reading;
    const art::Channel frame =
        read_channel(layer.json, "tm", 0, 0, animation.frame_rate, outer.time, outer.budget);
    std::vector<TimePiece> pieces = time_pieces(frame, layer.seen, outer.budget);
    keep_last_frame(pieces, number_at(layer.json, "op", largest_number));
    return pieces;
}

/// Where time goes unevenly, it goes into keys.
std::vector<art::Node> read_unevenly(const Layer& layer, const Json& layers,
                                     const std::vector<TimePiece>& pieces, Animation& animation)
{
    const Around unknown;
    Reading reading = inner_reading(layer, {});
    reading.symbols = nullptr;
    std::vector<art::Node> nodes = read_composition({layers, &unknown, range_of(pieces)}, animation, reading);
    retime(nodes, pieces, layer.reading.budget);
    return nodes;
}

/// How time goes in the composition while the layer is seen: evenly, or in pieces.
struct InnerTime {
    std::optional<LayerTime> even;
    std::vector<TimePiece> pieces = {};
};

InnerTime inner_time(const Layer& layer, const Animation& animation)
{
    if (!find_member(layer.json, "tm"))
        return {stretched(layer)};
    std::vector<TimePiece> pieces = read_pieces(layer, animation);
    const auto even = even_time(pieces);
    return {even, std::move(pieces)};
}

std::vector<art::Node> read_written_out(const Layer& layer, const Json& layers, const InnerTime& time,
                                        Animation& animation)
{
    if (!time.even)
        return read_unevenly(layer, layers, time.pieces, animation);
    return read_composition({layers, &layer.around, layer.seen}, animation, inner_reading(layer, *time.even));
}

/// What the canvas shows of a box inside of the layer; all of it where that is not known.
Box seen_part(Box box, const Layer& layer, double time, const Animation& animation)
{
    const auto matrix = canvas_matrix(&layer.around, time);
    const auto back = matrix ? matrix->inverse() : std::nullopt;
    if (!back || box.empty())
        return box;
    Box canvas;
    for (const scene::Vec2 corner : Box{0, 0, animation.width, animation.height}.corners())
        canvas.include(back->of(corner));
    return {std::max(box.left, canvas.left), std::max(box.top, canvas.top), std::min(box.right, canvas.right),
            std::min(box.bottom, canvas.bottom)};
}

Box edges_of(const Layer& layer)
{
    return {0, 0, number_at(layer.json, "w", 0), number_at(layer.json, "h", 0)};
}

/// When something is first visible beyond the edges.
std::optional<double> first_seen_beyond(const Box& edges, std::span<const art::Node> nodes,
                                        const Layer& layer, const Animation& animation)
{
    for (const double time :
         sample_times(layer.seen, weight(nodes) + weight(&layer.around), layer.reading.budget))
        if (!seen_part(box_at(nodes, time, {}, animation.symbols.boxes), layer, time, animation)
                 .lies_within(edges))
            return time;
    return std::nullopt;
}

/// A composition is clipped to its own edges, but a scene only to those of the canvas. Says when something is
/// first seen beyond them.
std::optional<double> first_seen_beyond(std::span<const art::Node> nodes, const Layer& layer,
                                        Animation& animation)
{
    const Box edges = edges_of(layer);
    const auto time = edges.empty() ? std::nullopt : first_seen_beyond(edges, nodes, layer, animation);
    if (time && is_within_symbol(&layer.around))
        animation.depends_on_place = true;
    return time;
}

void cut_at_edges(std::vector<art::Node>& nodes, double first_beyond, const Layer& layer)
{
    const Box edges = edges_of(layer);
    const art::Drawing frame{{scene::rectangle({0, 0}, edges.right, edges.bottom, 0)}};
    if (!cut_to(window_of(frame), nodes, layer.seen, layer.reading.budget))
        layer.reading.losses.add({"edge of a precomposition", layer.reading.layer, first_beyond,
                                  "what reaches beyond it is seen"});
}

/// Nothing if something is seen beyond the edges, which a use does not have.
std::optional<art::Node> within_edges(const std::optional<art::Use>& use, const Layer& layer,
                                      Animation& animation)
{
    if (!use)
        return std::nullopt;
    art::Node node;
    node.content = *use;
    return first_seen_beyond({&node, 1}, layer, animation) ? std::nullopt : std::optional{std::move(node)};
}

/// What the composition draws, whose `layers` these are; cut where it is seen beyond the edges.
std::vector<art::Node> read_cut(const Layer& layer, const Json& layers, const InnerTime& time,
                                Animation& animation)
{
    std::vector<art::Node> nodes = read_written_out(layer, layers, time, animation);
    const auto beyond = first_seen_beyond(nodes, layer, animation);
    if (!beyond)
        return nodes;
    if (layer.reading.symbols && !animation.symbols.list.empty()) { // which cannot be cut
        Reading reading = layer.reading;
        reading.symbols = nullptr;
        nodes = read_written_out({layer.json, reading, layer.around, layer.seen}, layers, time, animation);
    }
    cut_at_edges(nodes, *beyond, layer);
    return nodes;
}

}

std::vector<art::Node> read_precomposition(const Layer& layer, Animation& animation)
{
    const Opened opened{layer, animation};
    const Json& layers = opened.layers();
    const Reading inside = inner_reading(layer, {});
    if (const auto looped = looped_time(layer.json, layer.reading.time, layer.seen, animation.frame_rate,
                                        layer.reading.budget))
        if (auto node = within_edges(use_looped(layer, layers, *looped, inside, animation), layer, animation))
            return {std::move(*node)};
    const InnerTime time = inner_time(layer, animation);
    if (time.even)
        if (auto node =
                within_edges(use_evenly(layer, layers, *time.even, inside, animation), layer, animation))
            return {std::move(*node)};
    return read_cut(layer, layers, time, animation);
}

}
