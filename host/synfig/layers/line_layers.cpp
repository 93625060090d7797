#include "host/synfig/layers/layers_reader.hpp"

#include "host/synfig/bones/linked_skin.hpp"
#include "host/synfig/layers/line_shape.hpp"
#include "host/synfig/layers/shape_layers.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::synfig {
namespace {

// In pixels, and as a fraction: a line whose width changes by less has one width.
constexpr double same_width = 1.0 / 16;
constexpr double same_width_share = 1.0 / 64;

/// An outline, or an advanced one, with the parameters of both under one name.
class LineLayer {
public:
    explicit LineLayer(const Layer& layer) : layer_{layer}, advanced_{layer.type() == "advanced_outline"} {}

    art::Node node()
    {
        lose_what_is_not_carried_over();
        art::Node node = has_one_width() ? plain() : varying();
        if (moves_)
            move_by_origin(node, layer_);
        return node;
    }

private:
    void lose_what_is_not_carried_over() const
    {
        if (layer_.number("feather", 0, 0) > 0 || !layer_.bends({"feather"}).empty())
            layer_.lose("soft edge", "a sharp one");
        if (layer_.truth("dash_enabled", 0, false))
            layer_.lose("dashes", "a line without gaps");
        if (layer_.truth("invert", 0, false))
            layer_.lose("inverted outline", "the outline itself");
        const List widths = points("wplist", 0);
        for (std::size_t i = 1; i + 1 < widths.entries.size(); ++i) {
            const WidthPoint point = widths.entries[i].as<WidthPoint>();
            if (point.before != Side::interpolate || point.after != Side::interpolate)
                layer_.lose("gap of a width point", "a line without gaps");
        }
        layer_.lose_others({"bline",        "width",         "expand",
                            "origin",       "color",         "sharp_cusps",
                            "round_tip[0]", "round_tip[1]",  "homogeneous_width",
                            "homogeneous",  "wplist",        "dilist",
                            "start_tip",    "end_tip",       "cusp_type",
                            "smoothness",   "dash_enabled",  "dash_offset",
                            "fast",         "feather",       "blurtype",
                            "invert",       "winding_style", "loopyness"});
    }

    List points(const char* name, double frame) const { return layer_.at(name, frame).as<List>(); }

    /// Half of the width in pixels at a point with that width.
    double half_width(double own, double frame) const
    {
        const auto& scale_factor = layer_.scope().line_scale_factor;
        const double units = own * layer_.number("width", frame, 1) / 2 + layer_.number("expand", frame, 0);
        return std::abs(units) * layer_.reading().pixels_per_unit * (scale_factor ? scale_factor(frame) : 1);
    }

    std::vector<double> half_widths(double frame) const
    {
        std::vector<double> widths;
        for (const Value& entry : points("wplist", frame).entries)
            widths.push_back(half_width(entry.as<WidthPoint>().width, frame));
        if (widths.empty())
            for (const Value& entry : points("bline", frame).entries)
                widths.push_back(half_width(entry.as<SplinePoint>().width, frame));
        return widths;
    }

    std::vector<double> times() const
    {
        std::vector<double> times = layer_.bends({"bline", "wplist", "width", "expand"});
        times.push_back(0);
        for (double& time : times)
            time = std::min(time + 0.25, layer_.reading().frames);
        return times;
    }

    bool has_one_width() const
    {
        const bool plain_ends =
            begin() == end() && (begin() == Side::round || begin() == Side::square || begin() == Side::flat);
        if (!loops() && !(plain_ends && covers_all()))
            return false;
        return std::ranges::all_of(times(), [&](double time) {
            const auto widths = half_widths(time);
            if (widths.empty())
                return true;
            const auto [min, max] = std::ranges::minmax(widths);
            return max - min <= std::max(same_width / 2, same_width_share * max);
        });
    }

    /// Whether the width points cover the line from its beginning to its end.
    bool covers_all() const
    {
        const List widths = points("wplist", 0);
        if (widths.entries.empty() || loops())
            return true;
        return std::ranges::all_of(widths.entries, [](const Value& entry) {
            const WidthPoint point = entry.as<WidthPoint>();
            return (point.before == Side::interpolate || point.position <= 0) &&
                   (point.after == Side::interpolate || point.position >= 1);
        });
    }

    bool loops() const { return points("bline", 0).loop; }

    Side end_kind(const char* tip, const char* round) const
    {
        if (advanced_)
            return side_of(layer_.number(tip, 0, 1));
        return layer_.truth(round, 0, true) ? Side::round : Side::flat;
    }
    Side begin() const { return end_kind("start_tip", "round_tip[0]"); }
    Side end() const { return end_kind("end_tip", "round_tip[1]"); }

    Corner corner() const
    {
        if (!advanced_)
            return layer_.truth("sharp_cusps", 0, true) ? Corner::sharp : Corner::round;
        const double kind = layer_.number("cusp_type", 0, 0);
        return kind == 0 ? Corner::sharp : kind == 1 ? Corner::round : Corner::bevel;
    }

    art::Node plain() const
    {
        art::Node node = node_of(layer_);
        art::Shape shape;
        const std::function<art::Drawing(double)> drawing = [&](double frame) -> art::Drawing {
            const List spline = points("bline", frame);
            if (spline.entries.empty())
                return {};
            return {{layer_.reading().to_canvas.of(outline_along(spline, origin(frame)))}};
        };
        shape.skin = linked_skin(layer_);
        if (shape.skin)
            shape.drawing = drawing(0);
        else
            shape.drawing =
                traced(drawing, layer_.tracing({"bline", moves_ ? "" : "origin"}, place_tolerance));
        art::Fill paint = fill_of(layer_);
        art::StrokeStyle stroke;
        stroke.colour = std::move(paint.colour);
        stroke.opacity = std::move(paint.opacity);
        const std::function<double(double)> width = [&](double frame) {
            const auto widths = half_widths(frame);
            return widths.empty() ? 0 : 2 * *std::ranges::max_element(widths);
        };
        stroke.width = traced(width, layer_.tracing({"bline", "wplist", "width", "expand"}, place_tolerance));
        stroke.cap = begin() == Side::round ? Cap::round : begin() == Side::square ? Cap::square : Cap::butt;
        stroke.join = corner() == Corner::sharp   ? Join::miter
                      : corner() == Corner::round ? Join::round
                                                  : Join::bevel;
        // Synfig cuts corners off at two widths, and blunts them only there.
        stroke.miter_limit = 3;
        shape.stroke = std::move(stroke);
        node.content = std::move(shape);
        return node;
    }

    art::Node varying() const
    {
        art::Node node = node_of(layer_);
        art::Shape shape;
        const std::function<art::Drawing(double)> drawing = [&](double frame) { return drawn_at(frame); };
        shape.drawing =
            traced(drawing, layer_.tracing({"bline", "wplist", "width", "expand", moves_ ? "" : "origin"},
                                           place_tolerance));
        shape.fill = fill_of(layer_);
        shape.fill->rule = FillRule::nonzero;
        node.content = std::move(shape);
        return node;
    }

    art::Drawing drawn_at(double frame) const
    {
        const List spline = points("bline", frame);
        const std::size_t count = spline.entries.size();
        VaryingLine stroke;
        stroke.loop = spline.loop && count > 1;
        for (std::size_t i = 0; i + (stroke.loop ? 0 : 1) < count; ++i)
            stroke.pieces.push_back(piece(spline.entries[i].as<SplinePoint>(),
                                          spline.entries[(i + 1) % count].as<SplinePoint>(), frame));
        if (stroke.pieces.empty())
            return {};
        stroke.begin = begin();
        stroke.end = end();
        stroke.corner = corner();
        set_widths(stroke, spline, frame);
        return shape_of(stroke);
    }

    SplinePiece piece(SplinePoint from, SplinePoint to, double frame) const
    {
        const art::Affine& matrix = layer_.reading().to_canvas;
        const auto direction = [&](Vec2 spot) { return matrix.of(spot) - matrix.of(Vec2{}); };
        SplinePiece piece{from, to};
        const Vec2 begin = origin(frame);
        piece.from = matrix.of(begin + piece.from);
        piece.to = matrix.of(begin + piece.to);
        piece.leaving = direction(piece.leaving);
        piece.arriving = direction(piece.arriving);
        // Both 0: a straight line at constant speed.
        if (scene::dot(piece.leaving, piece.leaving) + scene::dot(piece.arriving, piece.arriving) < 1e-12)
            piece.leaving = piece.arriving = piece.to - piece.from;
        return piece;
    }

    void set_widths(VaryingLine& stroke, const List& spline, double frame) const
    {
        std::vector<double> begins{0};
        for (const SplinePiece& piece : stroke.pieces)
            begins.push_back(begins.back() + piece.length());
        stroke.to = begins.back();
        const List widths = points("wplist", frame);
        stroke.smoothness = advanced_ ? layer_.number("smoothness", frame, 1) : 0;
        if (widths.entries.empty())
            for (std::size_t i = 0; i < begins.size(); ++i)
                stroke.stops.push_back(
                    {begins[i],
                     half_width(spline.entries[i % spline.entries.size()].as<SplinePoint>().width, frame)});
        else
            set_width_points(stroke, widths, begins, frame);
    }

    void set_width_points(VaryingLine& stroke, const List& widths, const std::vector<double>& begins,
                          double frame) const
    {
        const double total = begins.back();
        const bool by_length = layer_.truth("homogeneous", frame, false);
        std::vector<std::pair<WidthStop, WidthPoint>> all;
        for (const Value& entry : widths.entries) {
            const WidthPoint point = entry.as<WidthPoint>();
            const double share = std::clamp(point.position, 0.0, 1.0);
            const double along = share * static_cast<double>(stroke.pieces.size());
            const std::size_t piece = std::min(stroke.pieces.size() - 1, static_cast<std::size_t>(along));
            const double distance =
                by_length ? share * total
                          : begins[piece] + stroke.pieces[piece].length(along - static_cast<double>(piece));
            all.push_back({{distance, half_width(point.width, frame)}, point});
        }
        std::ranges::stable_sort(all, {}, [](const auto& one) { return one.first.distance; });
        for (const auto& [stop, point] : all)
            stroke.stops.push_back(stop);
        if (stroke.loop) {
            WidthStop before = stroke.stops.back();
            WidthStop behind = stroke.stops.front();
            before.distance -= total;
            behind.distance += total;
            stroke.stops.insert(stroke.stops.begin(), before);
            stroke.stops.push_back(behind);
            return;
        }
        if (all.front().second.before != Side::interpolate) {
            stroke.from = all.front().first.distance;
            stroke.begin = all.front().second.before;
        }
        if (all.back().second.after != Side::interpolate) {
            stroke.to = all.back().first.distance;
            stroke.end = all.back().second.after;
            stroke.dip = 1;
        }
    }

    Vec2 origin(double frame) const { return moves_ ? Vec2{} : layer_.spot("origin", frame); }

    const Layer& layer_;
    bool advanced_;
    bool moves_ = moves_as_a_whole(layer_);
};

}

std::optional<art::Node> read_line_layer(const Layer& layer)
{
    if (layer.type() != "outline" && layer.type() != "advanced_outline")
        return {};
    return LineLayer{layer}.node();
}

}
