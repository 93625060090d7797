#include "host/scene_text/scene_text.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/art/prepare/prepare.hpp"
#include "host/kdl/document.hpp"
#include "host/kdl/readable.hpp"
#include "host/program/failure.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene_text/arrange/arrange.hpp"
#include "host/scene_text/arrange/placement.hpp"
#include "host/scene_text/bones/rig_text.hpp"
#include "host/scene_text/drawings/drawing_nodes.hpp"
#include "host/scene_text/items/item_text.hpp"
#include "host/scene_text/items/symbol_text.hpp"
#include "host/scene_text/values/grid.hpp"
#include "host/scene_text/values/nodes.hpp"
#include "host/scene_text/values/writing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace kfast::scene_text {

namespace {

bool has_depth(const std::vector<art::Node>& nodes)
{
    return std::ranges::any_of(nodes, [](const art::Node& node) {
        const auto* const group = std::get_if<art::Group>(&node.content);
        return !lies_flat(node.transform) || node.transform.z != art::Channel{0} ||
               (group != nullptr && has_depth(group->nodes));
    });
}

/// The distance of the viewer of a scene, in pixels: nothing where no depth is visible. Without a camera in
/// the document, what rotates in space gets the largest distance, so that there is hardly any perspective.
std::optional<std::size_t> camera_of(const art::Document& document)
{
    if (!has_depth(document.nodes) &&
        std::ranges::none_of(document.symbols, [](const auto& symbol) { return has_depth(symbol.nodes); }))
        return std::nullopt;
    const double distance = document.camera.value_or(kfb::max_camera);
    return static_cast<std::size_t>(
        std::clamp<double>(std::round(distance), kfb::min_camera, kfb::max_camera));
}

class MarkerText {
public:
    MarkerText(const art::Document& document, std::int32_t length, art::Losses& losses)
        : length_{length}, repeats_{document.loop == Loop::repeat}, losses_{losses}
    {
        std::vector<art::Marker> markers = document.markers;
        std::ranges::stable_sort(markers, {}, &art::Marker::time);
        for (const art::Marker& marker : markers)
            add(marker);
    }

    std::vector<kdl::Node> take()
    {
        std::ranges::move(events_, std::back_inserter(clips_));
        return std::move(clips_);
    }

private:
    void add(const art::Marker& marker)
    {
        const double end = marker.time + marker.duration;
        if (marker.time > off_grid(length_, times) || (marker.time < 0 && end <= 0)) {
            losses_.add({"marker outside of the animation", clean_name(marker.name, "marker"), marker.time,
                         "it is left out"});
            return;
        }
        if (marker.duration > 0)
            add_clip(marker.name, on_grid(marker.time, times), std::min(on_grid(end, times), length_));
        if (marker.time >= 0)
            add_event(marker.name, std::min(on_grid(marker.time, times), length_));
    }

    void add_clip(const std::string& name, std::int32_t from, std::int32_t to)
    {
        if (to <= from)
            return;
        if (clips_.size() == scene::max_clips) {
            losses_.add({"more than " + std::to_string(scene::max_clips) + " markers that last",
                         "",
                         {},
                         "the first of them are clips, the others only events"});
            return;
        }
        kdl::Node clip = named_node("clip", text(names_.unique(name, "clip")));
        set(clip, "from", number(from, times));
        set(clip, "to", number(to, times));
        clips_.push_back(std::move(clip));
    }

    /// The end of a scene that repeats is its beginning.
    void add_event(const std::string& name, std::int32_t ticks)
    {
        const std::int32_t moment = repeats_ && ticks == length_ ? 0 : ticks;
        events_.push_back(named_node("event", number(moment, times), text(clean_name(name, "marker"))));
    }

    std::int32_t length_;
    bool repeats_;
    art::Losses& losses_;
    Names names_ = {};
    std::vector<kdl::Node> clips_ = {};
    std::vector<kdl::Node> events_ = {};
};

/// An event for each marker, and a clip for each that lasts, in the order of their times.
std::vector<kdl::Node> marker_nodes(const art::Document& document, std::int32_t length, art::Losses& losses)
{
    return MarkerText{document, length, losses}.take();
}

using art::Document;

constexpr double default_frame_rate = 30;
constexpr std::array<std::string_view, 2> crowded{"at", "points"};

std::size_t whole_pixels(double size)
{
    const double pixels = std::max(std::round(size), 1.0);
    if (pixels > scene::widest_canvas)
        throw Failure("the canvas would be " + std::to_string(std::lround(std::min(size, 1e9))) +
                      " pixels wide or high; a scene has at most " + std::to_string(scene::widest_canvas) +
                      "; make the picture smaller");
    return static_cast<std::size_t>(pixels);
}

/// Throws Failure if the scene is too long.
std::int32_t ticks_of(const Document& document)
{
    if (document.frames > scene::max_frames)
        throw Failure("the animation is longer than " + std::to_string(scene::max_frames) +
                      " frames, the longest scene; cut it into several");
    return std::max(on_grid(document.frames, times), Time::ticks_per_frame);
}

kdl::Node canvas_node(const Document& document, Writing& writing)
{
    kdl::Node canvas =
        named_node("canvas", number(whole_pixels(document.width)), number(whole_pixels(document.height)));
    if (document.frame_rate != default_frame_rate)
        set(canvas, "fps", number(on_grid(document.frame_rate, frame_rates), frame_rates));
    set(canvas, "frames", number(writing.length, times));
    if (document.loop != Loop::repeat)
        set(canvas, "loop", loop_word(document.loop));
    if (document.background)
        set(canvas, "background",
            text(writing.colours.word(stored_colour(*document.background, 1), "background")));
    if (const auto camera = camera_of(document))
        set(canvas, "camera", number(*camera));
    return canvas;
}

/// Leaves out the folder, which means nothing elsewhere.
std::string first_lines(std::string_view origin)
{
    const std::string name = clean_name(origin.substr(origin.find_last_of('/') + 1), "");
    return name.empty() ? "kfast 1\n" : "// Made from " + name + ".\n\nkfast 1\n";
}

/// The text of nodes after an empty line.
std::string section(const std::vector<kdl::Node>& nodes)
{
    return nodes.empty() ? std::string{} : '\n' + kdl::readable(nodes, crowded);
}

}

SceneText scene_text(const Document& document, std::string_view origin, double tolerance, art::Losses& losses)
{
    Document arranged = document;
    check_finite(arranged);
    const std::int32_t length = ticks_of(arranged);
    art::crop(arranged, losses);
    art::Budget budget;
    Reach reach = arrange(arranged, {length, tolerance, losses, budget});
    Writing writing{length, losses, budget};
    writing.rigs = rig_names(arranged.rigs);
    const std::vector<kdl::Node> canvas{canvas_node(arranged, writing)};
    end_symbols(arranged);
    name_symbols(arranged, writing);
    std::vector<kdl::Node> items = item_nodes(arranged.nodes, writing);
    std::vector<kdl::Node> symbols = symbol_nodes(arranged, writing);
    std::ranges::move(share_drawings(symbols, items, writing.symbol_names), std::back_inserter(symbols));
    const std::vector<kdl::Node> rigs = rig_nodes(arranged, writing, reach);
    const std::vector<kdl::Node> markers = marker_nodes(arranged, length, losses);
    return {first_lines(origin) + kdl::readable(canvas, crowded) + section(writing.colours.nodes()) +
                section(rigs) + section(symbols) + section(items) + section(markers),
            reach};
}

}
