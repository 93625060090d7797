#include "host/scene/values/canvas_reader.hpp"

#include "core/scene/kfb_limits.hpp"
#include "core/scene/scene_view.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"

#include <cmath>
#include <optional>

namespace kfast::scene {

namespace {

constexpr NodeForm canvas_form{"canvas", "canvas WIDTH HEIGHT fps=30", 2, 2};
constexpr Range sizes{1, widest_canvas};
constexpr Range frame_rates{1, fastest};
constexpr Range camera_distances{kfb::min_camera, kfb::max_camera};

/// A length in seconds has to wait for the frame rate, which may come after it.
struct Canvas {
    double frames_per_second = 30;
    Loop loop = Loop::repeat;
    bool has_background = false;
    const kdl::Value* length = nullptr;
    std::optional<int> camera;
    bool has_routes = false;
};

bool read_rate(const kdl::Value& value, Canvas& canvas, SceneContext& context)
{
    return assign(read_number(value, frame_rates, context.report), canvas.frames_per_second);
}

bool read_background(const kdl::Value& value, Canvas& canvas, SceneContext& context)
{
    const auto background = read_colour(value, context);
    canvas.has_background = background.has_value();
    if (!background || context.palette.used()[*background].opacity == 255)
        return canvas.has_background;
    return context.report.error(value.place, "the background cannot be transparent",
                                "leave out the opacity of this colour");
}

bool read_loop(const kdl::Value& value, Canvas& canvas, SceneContext& context)
{
    return assign(read_loop(value, context), canvas.loop);
}

bool keep_length(const kdl::Value& value, Canvas& canvas, SceneContext&)
{
    canvas.length = &value;
    return true;
}

bool read_camera(const kdl::Value& value, Canvas& canvas, SceneContext& context)
{
    canvas.camera = read_whole_number(value, camera_distances, context.report);
    return canvas.camera.has_value();
}

bool read_route(const kdl::Value& value, Canvas& canvas, SceneContext& context)
{
    return assign(read_flag(value, context.report), canvas.has_routes);
}

constexpr std::array canvas_rules{
    PropertyRule<Canvas>{"fps", read_rate, ValueKind::number(frame_rates)},
    PropertyRule<Canvas>{"background", read_background, any_colour},
    PropertyRule<Canvas>{"loop", read_loop, ValueKind::one_of<loops>()},
    PropertyRule<Canvas>{"frames", keep_length, any_time},
    PropertyRule<Canvas>{"camera", read_camera, ValueKind::whole(camera_distances)},
    PropertyRule<Canvas>{"route", read_route, truth},
};

std::optional<Time> read_length(const kdl::Value& value, SceneContext& context)
{
    const auto length = read_time(value, context);
    if (!length || *length >= Time::frame(1))
        return length;
    context.report.error(value.place, "a scene cannot be shorter than one frame");
    return std::nullopt;
}

}

void read_canvas(const kdl::Node& node, Scene& scene, SceneContext& context)
{
    if (!fits(node, canvas_form, context.report))
        return;
    assign(read_whole_number(node.arguments[0], sizes, context.report), scene.canvas.width);
    assign(read_whole_number(node.arguments[1], sizes, context.report), scene.canvas.height);
    Canvas canvas;
    read_properties(node, canvas_rules, canvas, context);
    if (!canvas.has_background)
        context.palette.use(Colour{});
    // Rounded once to 1/1000 fps, halves away from zero.
    context.frame_rate = static_cast<std::uint32_t>(std::lround(canvas.frames_per_second * 1000));
    scene.frame_rate = context.frame_rate;
    scene.loop = canvas.loop;
    scene.has_routes = canvas.has_routes;
    scene.camera = canvas.camera.value_or(static_cast<int>(default_camera(scene.canvas)));
    if (canvas.length != nullptr)
        context.length = read_length(*canvas.length, context);
}

NodeSchema canvas_schema()
{
    return {canvas_form.name, canvas_form, {ValueKind::whole(sizes)}, schema_of(canvas_rules)};
}

namespace {

constexpr NodeForm palette_form{"palette", "palette { NAME \"#rrggbb\" }", 0, 0, true};

/// `name` is the scene's name for its colour.
constexpr NodeForm colour_form(std::string_view name) { return {name, "NAME \"#rrggbb\"", 1, 1}; }

/// A palette knows basic and hexadecimal colours, not its own names.
std::optional<Colour> read_plain_colour(const kdl::Value& value, SceneContext& context)
{
    static const Palette plain;
    const auto text = read_text(value, context.report);
    const auto colour = text ? plain.find(std::string{*text}) : std::nullopt;
    if (text && !colour)
        report_unknown_colour(value, *text, plain, context);
    return colour;
}

void read_named_colour(const kdl::Node& node, SceneContext& context)
{
    if (!fits(node, colour_form(node.name), context.report) || !refuse_properties(node, context.report))
        return;
    // A wrong colour does not make every use of its name wrong as well.
    const Colour colour = read_plain_colour(node.arguments.front(), context).value_or(Colour{});
    if (context.palette.declared() == max_colours) {
        context.report.error(node.name_span,
                             "a palette holds at most " + std::to_string(max_colours) + " colours");
        return;
    }
    if (const auto earlier = context.palette.declare(node.name, colour, node.name_span))
        report_duplicate("a colour", node.name, node.name_span, *earlier, context.report);
}

}

void read_palette(const kdl::Node& node, SceneContext& context)
{
    if (!fits(node, palette_form, context.report) || !refuse_properties(node, context.report))
        return;
    for (const kdl::Node& colour : node.children)
        if (!context.report.full())
            read_named_colour(colour, context);
}

std::vector<NodeSchema> palette_schema()
{
    constexpr std::string_view colour = "colour of palette";
    return {{palette_form.name, palette_form, {}, {}, {colour}},
            {colour, colour_form("NAME"), {any_colour}, {}, {}, true}};
}

}
