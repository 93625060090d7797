#include "host/scene_text/scene_text.hpp"

#include "host/art/prepare/prepare.hpp"
#include "host/kdl/readable.hpp"
#include "host/program/failure.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene_text/arrange/arrange.hpp"
#include "host/scene_text/arrange/camera.hpp"
#include "host/scene_text/bones/rig_text.hpp"
#include "host/scene_text/drawings/shared_drawings.hpp"
#include "host/scene_text/items/item_text.hpp"
#include "host/scene_text/items/marker_text.hpp"
#include "host/scene_text/values/grid.hpp"
#include "host/scene_text/values/nodes.hpp"
#include "host/scene_text/values/writing.hpp"
#include "host/words/loop_name.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kfast::scene_text {
namespace {

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
        set(canvas, "loop", text(std::string{loop_name(document.loop)}));
    if (document.background)
        set(canvas, "background",
            text(writing.colours.word(stored_colour(*document.background, 1), "background")));
    if (const auto camera = camera_of(document))
        set(canvas, "camera", number(*camera));
    return canvas;
}

/// Without the folder, which means nothing elsewhere.
std::string first_lines(std::string_view origin)
{
    const std::string name = clean_name(origin.substr(origin.find_last_of('/') + 1), "");
    return name.empty() ? "kfast 1\n" : "// Made from " + name + ".\n\nkfast 1\n";
}

/// With an empty line in front of it.
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
    Reach reach = arrange(arranged.nodes, {length, tolerance, losses, budget});
    Writing writing{length, losses, budget};
    writing.rigs = rig_names(arranged.rigs);
    const std::vector<kdl::Node> canvas{canvas_node(arranged, writing)};
    std::vector<kdl::Node> items = item_nodes(arranged.nodes, writing);
    const std::vector<kdl::Node> symbols = share_drawings(items);
    const std::vector<kdl::Node> rigs = rig_nodes(arranged, writing, reach);
    const std::vector<kdl::Node> markers = marker_nodes(arranged, length, losses);
    return {first_lines(origin) + kdl::readable(canvas, crowded) + section(writing.colours.nodes()) +
                section(rigs) + section(symbols) + section(items) + section(markers),
            reach};
}

}
