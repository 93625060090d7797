#include "host/lottie/layers/layer.hpp"

#include "host/geometry/shape.hpp"
#include "host/lottie/drawings/extent.hpp"
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
std::vector<art::Node> read_remapped(const Layer& layer, const Json& layers, Animation& animation)
{
    const Reading& outer = layer.reading;
    const art::Channel frame =
        read_channel(layer.json, "tm", 0, 0, animation.frame_rate, outer.time, outer.budget);
    std::vector<TimePiece> pieces = time_pieces(frame, layer.seen, outer.budget);
    keep_last_frame(pieces, number_at(layer.json, "op", largest_number));
    if (const auto even = even_time(pieces))
        return read_composition({layers, &layer.around, layer.seen}, animation, inner_reading(layer, *even));
    const Around unknown;
    std::vector<art::Node> nodes =
        read_composition({layers, &unknown, range_of(pieces)}, animation, inner_reading(layer, {}));
    retime(nodes, pieces, outer.budget);
    return nodes;
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

/// When something is first visible beyond the edges.
std::optional<double> first_seen_beyond(const Box& edges, std::span<const art::Node> nodes,
                                        const Layer& layer, const Animation& animation)
{
    for (const double time :
         sample_times(layer.seen, weight(nodes) + weight(&layer.around), layer.reading.budget))
        if (!seen_part(box_at(nodes, time), layer, time, animation).lies_within(edges))
            return time;
    return std::nullopt;
}

/// A composition is clipped to its own edges, but a scene only to those of the canvas.
void cut_at_edges(std::vector<art::Node>& nodes, const Layer& layer, const Animation& animation)
{
    const Box edges{0, 0, number_at(layer.json, "w", 0), number_at(layer.json, "h", 0)};
    if (edges.empty())
        return;
    const auto time = first_seen_beyond(edges, nodes, layer, animation);
    if (!time)
        return;
    const art::Drawing frame{{scene::rectangle({0, 0}, edges.right, edges.bottom, 0)}};
    if (!cut_to(window_of(frame), nodes, layer.seen, layer.reading.budget))
        layer.reading.losses.add(
            {"edge of a precomposition", layer.reading.layer, time, "what reaches beyond it is seen"});
}

}

std::vector<art::Node> read_precomposition(const Layer& layer, Animation& animation)
{
    const Opened opened{layer, animation};
    std::vector<art::Node> nodes = find_member(layer.json, "tm")
                                       ? read_remapped(layer, opened.layers(), animation)
                                       : read_composition({opened.layers(), &layer.around, layer.seen},
                                                          animation, inner_reading(layer, stretched(layer)));
    cut_at_edges(nodes, layer, animation);
    return nodes;
}

}
